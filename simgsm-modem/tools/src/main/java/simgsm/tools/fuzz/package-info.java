/**
 * Fuzzing of codecs and centres: recorded frames with seeded mutations, so that a failure can be repeated.
 *
 * <p>Read first: {@link simgsm.tools.fuzz.Mutator}; then {@link simgsm.tools.fuzz.CodecFuzz}, which mutates single frames,
 * and {@link simgsm.tools.fuzz.FuzzStation}, a station whose frames are mutated.
 */
package simgsm.tools.fuzz;
