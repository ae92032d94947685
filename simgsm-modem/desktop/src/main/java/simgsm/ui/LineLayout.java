package simgsm.ui;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Insets;
import java.util.List;
import java.util.stream.Stream;

/**
 * The layout of a row or a column of {@link Arrange}.
 *
 * @param across true for a row
 * @param gap in units
 */
record LineLayout(boolean across, int gap) implements Arrange.FixedLayout {
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
            Dimension size = minimum && Arrange.grows(child) ? child.getMinimumSize() : child.getPreferredSize();
            along += length(size) + Theme.px(gap);
            other = Math.max(other, across ? size.height : size.width);
        }
        along = Math.max(0, along);
        Insets in = parent.getInsets();
        return new Dimension(
                (across ? along : other) + in.left + in.right, (across ? other : along) + in.top + in.bottom);
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
            spare -= Theme.px(gap) + (Arrange.grows(child) ? 0 : length(child.getPreferredSize()));
            growing += Arrange.grows(child) ? 1 : 0;
        }
        int at = across ? in.left : in.top;
        for (Component child : children) {
            int part = length(child.getPreferredSize());
            if (Arrange.grows(child)) {
                part = Math.max(0, spare / growing);
                spare -= part;
                growing--;
            }
            child.setBounds(across ? at : in.left, across ? in.top : at, across ? part : width, across ? height : part);
            at += part + Theme.px(gap);
        }
    }

    private int length(Dimension size) {
        return across ? size.width : size.height;
    }

    private static List<Component> visible(Container parent) {
        return Stream.of(parent.getComponents()).filter(Component::isVisible).toList();
    }
}
