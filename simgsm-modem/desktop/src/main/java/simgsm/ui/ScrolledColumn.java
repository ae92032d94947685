package simgsm.ui;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.beans.PropertyChangeListener;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.Scrollable;
import javax.swing.SwingUtilities;

/**
 * The content of a scroll pane, as high as the view; below its minimum height it scrolls, also to the component that gets the
 * focus.
 */
public final class ScrolledColumn extends JPanel implements Scrollable {
    private static final String FOCUS = "permanentFocusOwner";

    private final transient PropertyChangeListener focus = change -> {
        if (change.getNewValue() instanceof Component owner) {
            scrollTo(owner);
        }
    };

    /** @param content with a minimum size, as {@link Arrange#column} has one */
    public ScrolledColumn(JComponent content) {
        super(new BorderLayout());
        setOpaque(false);
        add(content, BorderLayout.CENTER);
    }

    /** Scrolls as far as needed to show a component, if it is one of the column's. */
    void scrollTo(Component component) {
        if (component != this && SwingUtilities.isDescendingFrom(component, this)) {
            scrollRectToVisible(SwingUtilities.convertRectangle(component.getParent(), component.getBounds(), this));
        }
    }

    @Override
    public void addNotify() {
        super.addNotify();
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addPropertyChangeListener(FOCUS, focus);
    }

    @Override
    public void removeNotify() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().removePropertyChangeListener(FOCUS, focus);
        super.removeNotify();
    }

    @Override
    public Dimension getPreferredScrollableViewportSize() {
        return getPreferredSize();
    }

    @Override
    public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
        return Theme.px(20);
    }

    @Override
    public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
        return visible.height;
    }

    @Override
    public boolean getScrollableTracksViewportWidth() {
        return true;
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
        return getParent() != null && getParent().getHeight() >= getMinimumSize().height;
    }
}
