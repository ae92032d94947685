/**
 * Spoilt traffic against codecs and centres: real frames, changed by a seeded hand, so that what fails fails again.
 *
 * <p>Read first: {@link simgsm.tools.fuzz.Mutator}; then {@link simgsm.tools.fuzz.CodecFuzz}, which spoils what one
 * program reads, and {@link simgsm.tools.fuzz.FuzzPeer}, a station whose every word may be spoilt.
 */
package simgsm.tools.fuzz;
