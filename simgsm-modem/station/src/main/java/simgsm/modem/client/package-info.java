/**
 * A real modem instead of M2: an AT client (TS 27.005, TS 27.007) as a deterministic core, and the line to the modem.
 *
 * <p>Read first: {@link simgsm.modem.client.AttachedModem}, then {@link simgsm.modem.client.CommandDialogue} and the
 * tables {@link simgsm.modem.client.SetupStep} and {@link simgsm.modem.client.DtmfDialect}. {@link
 * simgsm.modem.line.ModemLine} gives the core its time and its line.
 */
package simgsm.modem.client;
