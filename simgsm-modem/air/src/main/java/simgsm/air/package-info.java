/**
 * The air interface: identities, layer-3 messages of TS 24.008 and TS 24.011 as records, their codec, and the framing
 * (IPA and RSL) that carries them over TCP. Knows no socket.
 *
 * <p>Read first: {@link simgsm.air.Layer3Message}, then {@link simgsm.air.Layer3Codec}, then {@link simgsm.air.RslMessage}
 * and {@link simgsm.air.IpaFrame}.
 */
package simgsm.air;
