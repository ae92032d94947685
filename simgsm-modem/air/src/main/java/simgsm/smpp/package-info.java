/**
 * The protocol data units of SMPP 3.4 and their octets. Clause numbers are those of SMPP v3.4 issue 1.2.
 *
 * <p>Read first: {@link simgsm.smpp.SmppPdu} and {@link simgsm.smpp.SmppCodec}.
 */
package simgsm.smpp;
