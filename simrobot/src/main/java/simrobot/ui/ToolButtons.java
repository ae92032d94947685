package simrobot.ui;

import java.awt.Insets;
import javax.swing.AbstractButton;
import javax.swing.UIDefaults;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/** Buttons of tool rows, with smaller margins than Nimbus's. */
public final class ToolButtons {
    private ToolButtons() {}

    /** A button with the action's icon; the action's id becomes its component's name. */
    public static <B extends AbstractButton> B icon(B button, UserAction action) {
        return button(button, action, null);
    }

    /** A button with the action's icon, if it has one, and its name. */
    public static <B extends AbstractButton> B named(B button, UserAction action) {
        return button(button, action, action.name());
    }

    /** A button with the action's name and narrow margins: three fit into the width of a column. */
    public static <B extends AbstractButton> B tab(B button, UserAction action) {
        return button(button, action, action.name(), 3);
    }

    /** @param word replaces the action's name; null for none */
    public static <B extends AbstractButton> B button(B button, UserAction action, String word) {
        return button(button, action, word, word == null ? 7 : 10);
    }

    private static <B extends AbstractButton> B button(B button, UserAction action, String word, int side) {
        button.setAction(action);
        button.setHideActionText(true);
        button.setText(word);
        button.setIconTextGap(Theme.HALF);
        Theme.styled(button, it -> setMargins(it, side));
        return ComponentNames.name(button, action.id(), action.name());
    }

    private static void setMargins(AbstractButton button, int side) {
        Insets insets = new Insets(Theme.px(6), Theme.px(side), Theme.px(6), Theme.px(side));
        UIDefaults overrides = new UIDefaults();
        overrides.put("Button.contentMargins", insets);
        overrides.put("ToggleButton.contentMargins", insets);
        button.putClientProperty("Nimbus.Overrides.InheritDefaults", true);
        button.putClientProperty("Nimbus.Overrides", overrides);
    }
}
