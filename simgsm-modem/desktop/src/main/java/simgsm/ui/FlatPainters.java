package simgsm.ui;

import java.util.regex.Pattern;
import javax.swing.UIDefaults;

/** Replaces Nimbus's painters by flat ones: a fill, a thin line, a ring for the focus; the states come from the key. */
final class FlatPainters {
    /** Such as {@code Button[Focused+MouseOver].backgroundPainter}: the region, its states, the kind of painter. */
    private static final Pattern KEY = Pattern.compile("([^\\[]+)\\[([^\\]]*)\\]\\.(\\w+Painter)");

    private FlatPainters() {}

    static void replaceIn(UIDefaults defaults) {
        for (Object key : defaults.keySet().toArray()) {
            var match = KEY.matcher(key.toString());
            if (match.matches()) {
                FlatPainter painter = FlatPainter.of(match.group(1), match.group(2), match.group(3));
                if (painter != null) {
                    defaults.put(key, painter);
                }
            }
        }
    }
}
