/**
 * The air interface: identities, the layer-3 messages of TS 24.008 and TS 24.011 as records, and their codec. A new
 * message is a record, a row of {@link simgsm.air.Layer3Type} and a line in the codec of its protocol.
 *
 * <p>Read first: {@link simgsm.air.Layer3Message}, then {@link simgsm.air.Layer3Codec}.
 */
package simgsm.air;
