package simgsm.center.journal;

import java.util.function.Supplier;

/** What must hold whatever happens. */
final class Invariant {
    private static final boolean IS_TOLD = Boolean.getBoolean("simulation.told");

    private Invariant() {}

    /** What happens, for who looks for the reason that one does not hold: {@code -Dsimulation.told=true}. */
    static void tell(Supplier<String> news) {
        if (IS_TOLD) {
            System.out.println(news.get());
        }
    }

    static void holds(boolean isSo, Supplier<String> otherwise) {
        if (!isSo) {
            throw new AssertionError(otherwise.get());
        }
    }
}
