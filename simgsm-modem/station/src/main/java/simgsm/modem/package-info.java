/**
 * M2: the GSM modem on a mobile station. It answers calls, decodes keys, plays reply tones, and receives and sends
 * short messages; the listener interprets them.
 *
 * <p>Read first: {@link simgsm.modem.Modem}, then {@link simgsm.modem.ModemEvent}.
 */
package simgsm.modem;
