package simgsm.ui;

import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;
import javax.swing.AbstractButton;
import javax.swing.ButtonModel;
import javax.swing.Icon;
import javax.swing.JComponent;
import javax.swing.plaf.UIResource;

/** The box of a check box; unlike Nimbus's icon it follows the zoom. */
final class CheckBoxIcon implements Icon, UIResource {
    private static final double UNITS = 18;

    @Override
    public int getIconWidth() {
        return Theme.px(UNITS);
    }

    @Override
    public int getIconHeight() {
        return Theme.px(UNITS);
    }

    @Override
    public void paintIcon(Component component, Graphics graphics, int x, int y) {
        Graphics2D g = Drawing.on(graphics);
        try {
            g.translate(x, y);
            new FlatPainter(FlatPainter::check, statesOf((AbstractButton) component))
                    .paint(g, (JComponent) component, getIconWidth(), getIconHeight());
        } finally {
            g.dispose();
        }
    }

    private static List<String> statesOf(AbstractButton button) {
        ButtonModel model = button.getModel();
        List<String> states = new ArrayList<>();
        states.add(model.isEnabled() ? "Enabled" : "Disabled");
        if (model.isSelected()) {
            states.add("Selected");
        }
        if (button.isFocusOwner()) {
            states.add("Focused");
        }
        return states;
    }
}
