package simgsm.ui.pane;

import java.awt.Container;
import java.awt.Dimension;
import java.util.function.IntUnaryOperator;
import javax.swing.JComponent;
import javax.swing.JPanel;
import simgsm.ui.Arrange;
import simgsm.ui.Theme;

/** Two parts side by side, or one above the other, with a {@link Divider} between them while both are visible. */
public final class DividedPanel extends JPanel {
    private final boolean sideBySide;
    private final JComponent first;
    private final JComponent second;
    private final Divider divider;
    private final int leastFirstUnits;
    private final IntUnaryOperator own;

    /**
     * Both parts.
     *
     * @param divider gives the least size of the second part
     * @param own the second part's size in pixels by the pixels for both, until the user moves the divider
     */
    public DividedPanel(
            boolean sideBySide,
            JComponent first,
            JComponent second,
            Divider divider,
            int leastFirstUnits,
            IntUnaryOperator own) {
        super(null);
        this.sideBySide = sideBySide;
        this.first = first;
        this.second = second;
        this.divider = divider;
        this.leastFirstUnits = leastFirstUnits;
        this.own = own;
        setOpaque(false);
        add(first);
        add(divider);
        add(second);
        setLayout(new Parts());
    }

    /** Adds the second part, which may have another parent meanwhile, or removes it. */
    public void showSecond(boolean shown) {
        if (shown != hasSecond()) {
            if (shown) {
                add(second);
            } else {
                remove(second);
            }
            revalidate();
            repaint();
        }
    }

    /** True if the second part is here. */
    public boolean hasSecond() {
        return second.getParent() == this;
    }

    private boolean areBoth() {
        return first.isVisible() && hasSecond() && second.isVisible();
    }

    /** The part that has the whole area. */
    private JComponent only() {
        return first.isVisible() || !hasSecond() ? first : second;
    }

    private int length() {
        return sideBySide ? getWidth() : getHeight();
    }

    private final class Parts implements Arrange.FixedLayout {
        @Override
        public Dimension preferredLayoutSize(Container parent) {
            if (!areBoth()) {
                return only().getPreferredSize();
            }
            Dimension a = first.getPreferredSize();
            Dimension b = second.getPreferredSize();
            int gap = Theme.px(Theme.GRID);
            return sideBySide
                    ? new Dimension(a.width + gap + b.width, Math.max(a.height, b.height))
                    : new Dimension(Math.max(a.width, b.width), a.height + gap + b.height);
        }

        @Override
        public Dimension minimumLayoutSize(Container parent) {
            return new Dimension();
        }

        @Override
        public void layoutContainer(Container parent) {
            boolean both = areBoth();
            if (divider.isVisible() != both) {
                divider.setVisible(both);
            }
            if (!both) {
                only().setBounds(0, 0, getWidth(), getHeight());
                return;
            }
            int gap = Theme.px(Theme.GRID);
            int room = Math.max(0, length() - gap);
            int size = Math.min(room, divider.sized(own.applyAsInt(room), room - Theme.px(leastFirstUnits)));
            int before = room - size;
            if (sideBySide) {
                first.setBounds(0, 0, before, getHeight());
                divider.place(before, 0, gap, getHeight());
                second.setBounds(before + gap, 0, size, getHeight());
            } else {
                first.setBounds(0, 0, getWidth(), before);
                divider.place(0, before, getWidth(), gap);
                second.setBounds(0, before + gap, getWidth(), size);
            }
        }
    }
}
