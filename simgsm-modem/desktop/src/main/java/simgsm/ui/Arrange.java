package simgsm.ui;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Insets;
import java.awt.LayoutManager;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JPanel;

/**
 * Rows and columns whose gaps are in units of the theme and follow the zoom. Components marked by {@link #growing} share the
 * remaining length; the others get their preferred length. Each gets the full height of a row or width of a column.
 */
public final class Arrange {
    private static final String GROWS = "simgsm.grows";

    private Arrange() {}

    /** A row. @param gap in units */
    public static JPanel row(int gap, Component... children) {
        return panel(new Line(true, gap), children);
    }

    /** A column. @param gap in units */
    public static JPanel column(int gap, Component... children) {
        return panel(new Line(false, gap), children);
    }

    /** Marks a component as one that shares the remaining length. */
    public static <T extends JComponent> T growing(T component) {
        component.putClientProperty(GROWS, true);
        return component;
    }

    /** Marks a component, or takes its mark away. */
    static void setGrowing(JComponent component, boolean grows) {
        component.putClientProperty(GROWS, grows ? true : null);
        component.revalidate();
    }

    /** Empty space that grows. */
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

    static boolean grows(Component component) {
        return component instanceof JComponent c && c.getClientProperty(GROWS) != null;
    }

    private record Line(boolean across, int gap) implements FixedLayout {
        @Override
        public Dimension preferredLayoutSize(Container parent) {
            return size(parent, false);
        }

        @Override
        public Dimension minimumLayoutSize(Container parent) {
            return size(parent, true);
        }

        private Dimension size(Container parent, boolean minimum) {
            int along = -Theme.px(gap);
            int other = 0;
            for (Component child : visible(parent)) {
                Dimension size = minimum && grows(child) ? child.getMinimumSize() : child.getPreferredSize();
                along += (across ? size.width : size.height) + Theme.px(gap);
                other = Math.max(other, across ? size.height : size.width);
            }
            Insets in = parent.getInsets();
            int width = (across ? Math.max(0, along) : other) + in.left + in.right;
            int height = (across ? other : Math.max(0, along)) + in.top + in.bottom;
            return new Dimension(width, height);
        }

        @Override
        public void layoutContainer(Container parent) {
            List<Component> children = visible(parent);
            Insets in = parent.getInsets();
            int width = parent.getWidth() - in.left - in.right;
            int height = parent.getHeight() - in.top - in.bottom;
            int spare = (across ? width : height) + Theme.px(gap);
            int growing = 0;
            for (Component child : children) {
                spare -= Theme.px(gap) + (grows(child) ? 0 : length(child));
                growing += grows(child) ? 1 : 0;
            }
            int at = across ? in.left : in.top;
            for (Component child : children) {
                int part = length(child);
                if (grows(child)) {
                    part = Math.max(0, spare / growing);
                    spare -= part;
                    growing--;
                }
                if (across) {
                    child.setBounds(at, in.top, part, height);
                } else {
                    child.setBounds(in.left, at, width, part);
                }
                at += part + Theme.px(gap);
            }
        }

        private int length(Component child) {
            Dimension size = child.getPreferredSize();
            return across ? size.width : size.height;
        }

        private static List<Component> visible(Container parent) {
            return Stream.of(parent.getComponents())
                    .filter(Component::isVisible)
                    .toList();
        }
    }

    /** A layout that ignores the adding and removing of components. */
    public interface FixedLayout extends LayoutManager {
        @Override
        default void addLayoutComponent(String name, Component component) {}

        @Override
        default void removeLayoutComponent(Component component) {}
    }
}
