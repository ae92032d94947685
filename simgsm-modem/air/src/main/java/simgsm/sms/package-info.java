/**
 * Short messages and cell broadcast: what stands inside an RP-DATA (TS 23.040) and a broadcast page (TS 23.041), and how
 * text becomes octets (TS 23.038).
 *
 * <p>Read first: {@link simgsm.sms.UserData}, which is one part of a text as it travels; {@link simgsm.sms.MessageSplitter}
 * and {@link simgsm.sms.Reassembler}, which lead from text to parts and back; then {@link simgsm.sms.TpduCodec}.
 */
package simgsm.sms;
