package simgsm.ui;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.LayoutManager;
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
        return panel(new LineLayout(true, gap), children);
    }

    /** A column. @param gap in units */
    public static JPanel column(int gap, Component... children) {
        return panel(new LineLayout(false, gap), children);
    }

    /** Marks a component that shares the remaining length. */
    public static <T extends JComponent> T growing(T component) {
        component.putClientProperty(GROWS, true);
        return component;
    }

    /** Sets or removes a component's mark. */
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

    /** A layout that ignores the adding and removing of components. */
    public interface FixedLayout extends LayoutManager {
        @Override
        default void addLayoutComponent(String name, Component component) {}

        @Override
        default void removeLayoutComponent(Component component) {}
    }
}
