package simrobot.ui;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import javax.swing.JPanel;
import simgsm.ui.Arrange;
import simgsm.ui.Theme;

/** Two groups at the ends of a row; if they do not fit, the second wraps to another row. */
public final class SplitRow extends JPanel {
    private final Component left;
    private final Component right;

    public SplitRow(Component left, Component right) {
        super(null);
        this.left = left;
        this.right = right;
        setOpaque(false);
        add(left);
        add(right);
        setLayout(new Rows());
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                revalidate();
            }
        });
    }

    private boolean fitsInOneRow() {
        return getWidth() == 0 || left.getPreferredSize().width + gap() + right.getPreferredSize().width <= getWidth();
    }

    private static int gap() {
        return Theme.px(Theme.GRID);
    }

    private final class Rows implements Arrange.FixedLayout {
        @Override
        public Dimension preferredLayoutSize(Container parent) {
            Dimension a = left.getPreferredSize();
            Dimension b = right.getPreferredSize();
            return fitsInOneRow()
                    ? new Dimension(a.width + gap() + b.width, Math.max(a.height, b.height))
                    : new Dimension(Math.max(a.width, b.width), a.height + Theme.px(Theme.HALF) + b.height);
        }

        @Override
        public Dimension minimumLayoutSize(Container parent) {
            return new Dimension(Theme.px(200), preferredLayoutSize(parent).height);
        }

        @Override
        public void layoutContainer(Container parent) {
            Dimension a = left.getPreferredSize();
            Dimension b = right.getPreferredSize();
            if (fitsInOneRow()) {
                left.setBounds(0, (getHeight() - a.height) / 2, a.width, a.height);
                right.setBounds(getWidth() - b.width, (getHeight() - b.height) / 2, b.width, b.height);
            } else {
                left.setBounds(0, 0, Math.min(a.width, getWidth()), a.height);
                right.setBounds(0, getHeight() - b.height, Math.min(b.width, getWidth()), b.height);
            }
        }
    }
}
