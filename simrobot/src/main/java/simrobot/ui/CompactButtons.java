package simrobot.ui;

import java.awt.Container;
import java.awt.Insets;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.UIDefaults;
import simgsm.ui.Theme;

/** Buttons of a tool row: closer to their icons than Nimbus would have them. */
public final class CompactButtons {
    private CompactButtons() {}

    /** All buttons inside, at the theme's present zoom. */
    public static void buttonsIn(Container container) {
        for (var child : container.getComponents()) {
            if (child instanceof AbstractButton button) {
                dress(button, button.getText() == null || button.getText().isEmpty() ? 7 : 10);
            } else if (child instanceof Container inner) {
                buttonsIn(inner);
            }
        }
    }

    private static void dress(JComponent button, int side) {
        Insets insets = new Insets(Theme.px(6), Theme.px(side), Theme.px(6), Theme.px(side));
        UIDefaults overrides = new UIDefaults();
        overrides.put("Button.contentMargins", insets);
        overrides.put("ToggleButton.contentMargins", insets);
        button.putClientProperty("Nimbus.Overrides.InheritDefaults", true);
        button.putClientProperty("Nimbus.Overrides", overrides);
    }
}
