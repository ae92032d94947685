/**
 * M2: the GSM modem on top of a mobile station. It answers calls, hears keys, plays reply tones, takes and sends short
 * messages, and leaves what they mean to whoever listens.
 *
 * <p>Read first: {@link simgsm.modem.Modem}, then {@link simgsm.modem.ModemListener}.
 */
package simgsm.modem;
