/**
 * The AT commands of a GSM terminal (TS 27.005 and TS 27.007) on any {@link simgsm.modem.at.command.AtTerminal}:
 * their table, the state that the clients share (SIM memory, phone book, call) and that of each client, and the
 * unsolicited codes. A deterministic core: input is octets, station events and time, output is octets.
 *
 * <p>Read first: {@link simgsm.modem.at.command.AtModem}, then {@link simgsm.modem.at.command.AtCommands}.
 */
package simgsm.modem.at.command;
