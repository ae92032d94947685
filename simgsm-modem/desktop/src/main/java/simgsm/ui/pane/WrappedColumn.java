package simgsm.ui.pane;

import java.awt.Component;
import java.awt.Container;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;

/** A column of wrapping texts in a scroll pane: as wide as the view, as high as its texts. */
public final class WrappedColumn extends ScrollContent {
    private int measuredWidth;
    private int measuredHeight;
    private int neededHeight;

    public WrappedColumn(JComponent content) {
        super(content);
    }

    /**
     * The texts' height depends on their width: after a change of width or content, all are measured again until
     * nothing changes.
     */
    @Override
    public void doLayout() {
        super.doLayout();
        int height = getHeight();
        int width = getWidth();
        int needed = getPreferredSize().height;
        if (width != measuredWidth || height != measuredHeight || needed != neededHeight) {
            measuredWidth = width;
            measuredHeight = height;
            neededHeight = needed;
            SwingUtilities.invokeLater(() -> {
                forget(this);
                revalidate();
            });
        }
    }

    /** Containers keep their preferred size while they are valid. */
    private static void forget(Container container) {
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                forget(inner);
            }
            child.invalidate();
        }
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
        return getParent() != null && getParent().getHeight() > getPreferredSize().height;
    }
}
