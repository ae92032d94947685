package simgsm.ui.pane;

import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.beans.PropertyChangeListener;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;
import simgsm.ui.Arrange;

/**
 * The content of a scroll pane, as high as the view; it scrolls below its minimum height, also to the focused
 * component.
 */
public final class ScrolledColumn extends ScrollContent {
    private static final String FOCUS = "permanentFocusOwner";

    private final transient PropertyChangeListener focus = change -> {
        if (change.getNewValue() instanceof Component owner) {
            scrollTo(owner);
        }
    };

    /** @param content with a minimum size, as from {@link Arrange#column} */
    public ScrolledColumn(JComponent content) {
        super(content);
    }

    /** Scrolls to a component if it is one of the column's. */
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
    public boolean getScrollableTracksViewportHeight() {
        return getParent() != null && getParent().getHeight() >= getMinimumSize().height;
    }
}
