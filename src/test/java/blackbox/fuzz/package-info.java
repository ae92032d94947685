/**
 * Fuzzing of decoders, exchange and a running centre: recorded frames with seeded mutations, so that a failure can be
 * repeated.
 *
 * <p>Read first: {@link blackbox.fuzz.Mutator}; then {@link blackbox.fuzz.CodecFuzz}, which mutates single frames, and
 * {@link blackbox.fuzz.FuzzStation}, a station whose frames are mutated.
 */
package blackbox.fuzz;
