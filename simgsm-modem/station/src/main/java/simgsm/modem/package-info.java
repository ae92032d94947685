/**
 * M2: the GSM modem on top of a mobile station. It answers calls, decodes keys, plays reply tones, and receives and sends
 * short messages; their meaning is the listener's business.
 *
 * <p>Read first: {@link simgsm.modem.Modem}, then {@link simgsm.modem.ModemEvent}.
 */
package simgsm.modem;
