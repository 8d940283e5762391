//! Which serial devices there are, and the one to use.

use serialport::{SerialPortInfo, SerialPortType};

/// All serial devices, those with USB first.
fn all() -> Result<Vec<SerialPortInfo>, String> {
    let ports = serialport::available_ports();
    let mut ports = ports.map_err(|error| format!("can't list the serial devices: {error}"))?;
    ports.sort_by_key(|port| !matches!(port.port_type, SerialPortType::UsbPort(_)));
    Ok(ports)
}

/// A device and what is known of it, in a line.
fn describe(port: &SerialPortInfo) -> String {
    let kind = match &port.port_type {
        SerialPortType::UsbPort(usb) => {
            let words = [usb.manufacturer.as_deref(), usb.product.as_deref()];
            let words: Vec<&str> = words.into_iter().flatten().collect();
            format!("USB {:04x}:{:04x} {}", usb.vid, usb.pid, words.join(" "))
        }
        SerialPortType::BluetoothPort => "Bluetooth".into(),
        SerialPortType::PciPort => "on board".into(),
        SerialPortType::Unknown => String::new(),
    };
    format!("{}  {kind}", port.port_name).trim_end().to_string()
}

/// A line for each device.
pub fn list() -> Result<Vec<String>, String> {
    Ok(all()?.iter().map(describe).collect())
}

/// The only device with USB, or the only one at all.
pub fn only() -> Result<String, String> {
    let ports = all()?;
    let is_usb = |port: &&SerialPortInfo| matches!(port.port_type, SerialPortType::UsbPort(_));
    let usb: Vec<&SerialPortInfo> = ports.iter().filter(is_usb).collect();
    match (&usb[..], &ports[..]) {
        ([port], _) => Ok(port.port_name.clone()),
        ([], [port]) => Ok(port.port_name.clone()),
        ([], []) => Err("there is no serial device; say which with --port".into()),
        _ => {
            let list: Vec<String> = ports.iter().map(describe).collect();
            Err(format!(
                "there are several serial devices; choose one with --port:\n  {}",
                list.join("\n  ")
            ))
        }
    }
}
