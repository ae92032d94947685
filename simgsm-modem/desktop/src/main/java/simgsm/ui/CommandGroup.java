package simgsm.ui;

import java.util.Locale;
import simgsm.console.TextBundle;

/** The submenus of a window's menu, in their order. */
public enum CommandGroup {
    CALL,
    ROBOT,
    WORLD,
    NETWORK,
    VIEW,
    WINDOW;

    /** The name in the menu and in the help. */
    public String title(TextBundle texts) {
        return texts.of("group." + name().toLowerCase(Locale.ROOT));
    }
}
