/**
 * Short messages and cell broadcast: the contents of an RP-DATA (TS 23.040) and of a broadcast page (TS 23.041), and the
 * coding of text (TS 23.038).
 *
 * <p>Read first: {@link simgsm.sms.UserData}, one part of a text; {@link simgsm.sms.MessageSplitter} and
 * {@link simgsm.sms.Reassembler}, between text and parts; then {@link simgsm.sms.TpduCodec}.
 */
package simgsm.sms;
