package simgsm.ui;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Insets;
import java.awt.LayoutManager;
import javax.swing.JComponent;
import javax.swing.JPanel;

/**
 * Rows and columns whose gaps are in units of the theme and follow the zoom. A component wrapped by {@link #growing} takes
 * what room is left; the others get what they prefer, across the line all of it.
 */
public final class Arrange {
    private static final String GROWS = "simgsm.grows";

    private Arrange() {}

    /** Side by side. @param gap in units */
    public static JPanel row(int gap, Component... children) {
        return panel(new Line(true, gap), children);
    }

    /** One below the other. @param gap in units */
    public static JPanel column(int gap, Component... children) {
        return panel(new Line(false, gap), children);
    }

    /** Marks a component as one that takes the room that is left. */
    public static <T extends JComponent> T growing(T component) {
        component.putClientProperty(GROWS, true);
        return component;
    }

    /** Empty room that grows. */
    public static JComponent spring() {
        JPanel spring = new JPanel(null);
        spring.setOpaque(false);
        spring.setPreferredSize(new Dimension());
        return growing(spring);
    }

    private static JPanel panel(LayoutManager layout, Component... children) {
        JPanel panel = new JPanel(layout);
        panel.setOpaque(false);
        for (Component child : children) {
            panel.add(child);
        }
        return panel;
    }

    private static boolean grows(Component component) {
        return component instanceof JComponent c && c.getClientProperty(GROWS) != null;
    }

    private record Line(boolean across, int gap) implements LayoutManager {
        @Override
        public void addLayoutComponent(String name, Component component) {
            // Components are asked for when it matters.
        }

        @Override
        public void removeLayoutComponent(Component component) {
            // See above.
        }

        @Override
        public Dimension preferredLayoutSize(Container parent) {
            return size(parent, false);
        }

        @Override
        public Dimension minimumLayoutSize(Container parent) {
            return size(parent, true);
        }

        private Dimension size(Container parent, boolean minimum) {
            int along = 0;
            int beside = 0;
            int count = 0;
            for (Component child : parent.getComponents()) {
                if (child.isVisible()) {
                    Dimension size = minimum && grows(child) ? child.getMinimumSize() : child.getPreferredSize();
                    along += across ? size.width : size.height;
                    beside = Math.max(beside, across ? size.height : size.width);
                    count++;
                }
            }
            along += Math.max(0, count - 1) * Theme.px(gap);
            Insets in = parent.getInsets();
            int width = (across ? along : beside) + in.left + in.right;
            int height = (across ? beside : along) + in.top + in.bottom;
            return new Dimension(width, height);
        }

        @Override
        public void layoutContainer(Container parent) {
            Insets in = parent.getInsets();
            int length = across ? parent.getWidth() - in.left - in.right : parent.getHeight() - in.top - in.bottom;
            int breadth = across ? parent.getHeight() - in.top - in.bottom : parent.getWidth() - in.left - in.right;
            int spare = length - fixedLength(parent);
            int growers = growers(parent);
            int at = across ? in.left : in.top;
            for (Component child : parent.getComponents()) {
                if (!child.isVisible()) {
                    continue;
                }
                int part = length(child);
                if (grows(child)) {
                    part = Math.max(0, spare / growers);
                    spare -= part;
                    growers--;
                }
                if (across) {
                    child.setBounds(at, in.top, part, breadth);
                } else {
                    child.setBounds(in.left, at, breadth, part);
                }
                at += part + Theme.px(gap);
            }
        }

        private int length(Component child) {
            Dimension size = child.getPreferredSize();
            return across ? size.width : size.height;
        }

        private int fixedLength(Container parent) {
            int length = 0;
            int count = 0;
            for (Component child : parent.getComponents()) {
                if (child.isVisible()) {
                    length += grows(child) ? 0 : length(child);
                    count++;
                }
            }
            return length + Math.max(0, count - 1) * Theme.px(gap);
        }

        private static int growers(Container parent) {
            int count = 0;
            for (Component child : parent.getComponents()) {
                count += child.isVisible() && grows(child) ? 1 : 0;
            }
            return count;
        }
    }
}
