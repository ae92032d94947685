/**
 * Black-box tests over the finished programs, by the paper's own method: equivalence classes and boundaries of what a
 * user can do, told as scenarios. They start the real jars as processes and drive their consoles.
 *
 * <p>Read first: {@link blackbox.Scenario} and {@link blackbox.RunningProgram}, then {@code ThePapersExampleTest}.
 */
package blackbox;
