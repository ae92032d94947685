package simgsm.ui.lesson;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Rectangle;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.Scrollable;
import javax.swing.SwingUtilities;
import simgsm.ui.Theme;

/** A column of wrapping texts in a scroll pane: as wide as the view, as high as its texts. */
final class LessonColumn extends JPanel implements Scrollable {
    private int measuredWidth;
    private int measuredHeight;
    private int neededHeight;

    LessonColumn(JComponent content) {
        super(new BorderLayout());
        setOpaque(false);
        add(content, BorderLayout.CENTER);
    }

    /**
     * The texts' height depends on their width: after a change of the width, or of what is shown, all of them are measured anew,
     * until nothing changes.
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
        return getParent() != null && getParent().getHeight() > getPreferredSize().height;
    }
}
