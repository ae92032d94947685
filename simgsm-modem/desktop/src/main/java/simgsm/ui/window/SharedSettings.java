package simgsm.ui.window;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Theme and language of all windows of a user: publishes a change made in this window, and adopts one made in another
 * while this one is open. Values are those of the options {@code --theme} and {@code --lang}, shared through the
 * {@link WindowMemory}. Differences at the window's opening remain.
 */
final class SharedSettings {
    private final WindowMemory memory;
    private final Supplier<Map<String, String>> own;
    private final Consumer<Map<String, String>> adopt;
    private Map<String, String> lastOwn;
    private Map<String, String> lastKept;

    /**
     * @param own current values of this window
     * @param adopt applies another window's change to this one
     */
    SharedSettings(WindowMemory memory, Supplier<Map<String, String>> own, Consumer<Map<String, String>> adopt) {
        this.memory = memory;
        this.own = own;
        this.adopt = adopt;
        lastOwn = own.get();
        lastKept = memory.shared();
    }

    /** Publishes and adopts changes; call periodically on the event thread. */
    void look() {
        tell();
        Map<String, String> kept = memory.shared();
        if (!kept.equals(lastKept)) {
            Map<String, String> changed = changes(lastKept, kept);
            lastKept = kept;
            adopt.accept(changed);
            lastOwn = own.get();
        }
    }

    /** Publishes this window's changes. */
    void tell() {
        Map<String, String> now = own.get();
        if (!now.equals(lastOwn)) {
            changes(lastOwn, now).forEach(memory::keep);
            lastOwn = now;
            lastKept = memory.shared();
        }
    }

    private static Map<String, String> changes(Map<String, String> before, Map<String, String> now) {
        Map<String, String> changed = new TreeMap<>(now);
        changed.entrySet().removeAll(before.entrySet());
        return changed;
    }
}
