//! A WebSocket server (RFC 6455) that passes the line's bytes on to web pages, and their answers back:
//! binary messages of raw bytes both ways, and nothing else.

use std::io;
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::sync::mpsc::{Receiver, Sender, SyncSender, TryRecvError, channel, sync_channel};
use std::thread;
use std::time::Duration;
use tungstenite::handshake::server::{ErrorResponse, Request, Response};
use tungstenite::http::StatusCode;
use tungstenite::{Bytes, Error, Message, WebSocket};

/// So many messages wait for a page; a page that is slower is dropped.
const WAITING: usize = 4096;

/// So long an answer of a page may lie in its socket, and a byte of the line in memory.
const TICK: Duration = Duration::from_millis(3);

/// So long a page may take nothing.
const WRITE_WAIT: Duration = Duration::from_secs(5);

/// Serves any number of pages, each in a thread.
pub struct Server {
    address: SocketAddr,
    new: Receiver<SyncSender<Bytes>>,
    pages: Vec<SyncSender<Bytes>>,
    answers: Receiver<Bytes>,
}

impl Server {
    pub fn start(address: SocketAddr) -> Result<Self, String> {
        let fail = |error: io::Error| format!("can't serve at {address}: {error}");
        let listener = TcpListener::bind(address).map_err(fail)?;
        let address = listener.local_addr().map_err(fail)?;
        let (to_new, new) = channel();
        let (to_answers, answers) = channel();
        thread::spawn(move || {
            for stream in listener.incoming().flatten() {
                let (to_new, to_answers) = (to_new.clone(), to_answers.clone());
                thread::spawn(move || page(stream, &to_new, &to_answers));
            }
        });
        Ok(Self { address, new, pages: Vec::new(), answers })
    }

    /// Where it listens.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// Passes bytes of the line on.
    pub fn send(&mut self, bytes: &[u8]) {
        self.pages.extend(self.new.try_iter());
        let bytes = Bytes::copy_from_slice(bytes);
        self.pages.retain(|page| page.try_send(bytes.clone()).is_ok());
    }

    /// What a page has answered.
    pub fn answer(&self) -> Option<Bytes> {
        self.answers.try_recv().ok()
    }
}

/// Talks with one page until it is gone.
fn page(stream: TcpStream, to_new: &Sender<SyncSender<Bytes>>, answers: &Sender<Bytes>) {
    let _ = stream.set_nodelay(true);
    let _ = stream.set_write_timeout(Some(WRITE_WAIT));
    let _ = stream.set_read_timeout(Some(WRITE_WAIT));
    let Ok(mut socket) = tungstenite::accept_hdr(stream, only_local_pages) else { return };
    if socket.get_ref().set_read_timeout(Some(TICK)).is_err() {
        return;
    }
    let (to_page, line) = sync_channel(WAITING);
    if to_new.send(to_page).is_ok() {
        // The page is gone, or this program ends.
        let _ = talk(&mut socket, &line, answers);
        let _ = socket.close(None);
        let _ = socket.flush();
    }
}

fn talk(
    socket: &mut WebSocket<TcpStream>,
    line: &Receiver<Bytes>,
    answers: &Sender<Bytes>,
) -> Result<(), Error> {
    loop {
        match socket.read() {
            Ok(Message::Binary(bytes)) => {
                if answers.send(bytes).is_err() {
                    return Ok(());
                }
            }
            Ok(Message::Close(_)) => return Ok(()),
            Ok(_) => {}
            Err(Error::Io(error)) if crate::host::port::is_wait(&error) => {}
            Err(error) => return Err(error),
        }
        loop {
            match line.try_recv() {
                Ok(bytes) => socket.write(Message::Binary(bytes))?,
                Err(TryRecvError::Empty) => break,
                Err(TryRecvError::Disconnected) => return Ok(()),
            }
        }
        socket.flush()?;
    }
}

/// Refuses the pages of other hosts: any web page could read the line and write to it otherwise.
#[allow(clippy::result_large_err)] // the crate's own type
fn only_local_pages(request: &Request, response: Response) -> Result<Response, ErrorResponse> {
    let origin = request.headers().get("Origin").map(|origin| origin.to_str().unwrap_or("?"));
    if origin.is_none_or(is_local) {
        return Ok(response);
    }
    let mut refusal = ErrorResponse::new(Some("only pages of this computer are served".into()));
    *refusal.status_mut() = StatusCode::FORBIDDEN;
    Err(refusal)
}

/// Whether a page comes from this computer: from a file, or from a server on it.
fn is_local(origin: &str) -> bool {
    let Some((_, host)) = origin.split_once("://") else { return origin == "null" };
    let is_port = |rest: &str| rest.is_empty() || rest.starts_with(':');
    ["localhost", "127.0.0.1", "[::1]"]
        .iter()
        .any(|name| host.strip_prefix(name).is_some_and(is_port))
        || host.is_empty()
}
