/** The TCP port of a terminal's AT commands. Read {@link simgsm.modem.at.port.AtPort}. */
package simgsm.modem.at.port;
