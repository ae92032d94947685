package simgsm.ui.scope;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import simgsm.console.TextBundle;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.Drawing;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/** The buttons of a scope: symbols, with words if there is room. */
final class ScopeTools extends JPanel {
    private static final double SIDE_UNITS = 26;
    private static final double ICON_UNITS = 14;

    private final TextBundle texts;
    private final JPanel row = Arrange.row(Theme.HALF);
    private final List<AbstractButton> buttons = new ArrayList<>();

    ScopeTools(TextBundle texts) {
        super(new BorderLayout());
        this.texts = texts;
        setOpaque(false);
        Theme.styled(this, panel -> panel.setBorder(Theme.padding(0, 0, 4, 0)));
        add(row);
    }

    /** Adds a toggle button. @param id key of its word; its tool tip's ends with ".tip" */
    void toggle(String id, Symbol symbol, Consumer<Boolean> task) {
        JToggleButton button = new JToggleButton();
        dress(button, id, symbol, () -> task.accept(button.isSelected()));
    }

    /** Presses the button with this identifier. */
    void press(String id) {
        button(id).doClick(0);
    }

    /** True if the button with this identifier is down. */
    boolean isOn(String id) {
        return button(id).isSelected();
    }

    void setVisible(String id, boolean visible) {
        if (button(id).isVisible() != visible) {
            button(id).setVisible(visible);
            revalidate();
        }
    }

    private List<AbstractButton> shown() {
        return buttons.stream().filter(AbstractButton::isVisible).toList();
    }

    private AbstractButton button(String id) {
        return buttons.stream()
                .filter(each -> id.equals(each.getName()))
                .findFirst()
                .orElseThrow();
    }

    void button(String id, Symbol symbol, Runnable task) {
        dress(new JButton(), id, symbol, task);
    }

    private void dress(AbstractButton button, String id, Symbol symbol, Runnable task) {
        button.setAction(new UserAction(id, texts.of(id), task)
                .described(texts.of(id + ".tip"))
                .with(symbol.icon(ICON_UNITS)));
        ComponentNames.name(button, id, texts.of(id));
        button.getAccessibleContext().setAccessibleDescription(texts.of(id + ".tip"));
        Theme.styled(button, it -> {
            it.setFont(Theme.small());
            it.setBorder(Theme.padding(0, 4, 0, 4));
        });
        buttons.add(button);
        row.add(button);
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension((int) (shown().size() * Theme.exact(SIDE_UNITS)), Theme.px(SIDE_UNITS + Theme.HALF));
    }

    @Override
    public void doLayout() {
        List<AbstractButton> shown = shown();
        int words = shown.stream().mapToInt(this::wide).sum() + (shown.size() - 1) * Theme.px(Theme.HALF);
        boolean hasWords = words <= getWidth();
        int even = (getWidth() - (shown.size() - 1) * Theme.px(Theme.HALF)) / Math.max(1, shown.size());
        for (AbstractButton button : shown) {
            button.setHideActionText(!hasWords);
            button.setPreferredSize(new Dimension(
                    hasWords ? wide(button) : Math.min(even, Theme.px(1.5 * SIDE_UNITS)), Theme.px(SIDE_UNITS)));
        }
        super.doLayout();
        row.doLayout();
    }

    private int wide(AbstractButton button) {
        String word = texts.of(button.getName());
        return Drawing.width(Theme.small(), word) + Theme.px(ICON_UNITS + 20);
    }
}
