package simrobot.ui.inspector;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.stream.Collectors;
import javax.accessibility.AccessibleRole;
import javax.swing.AbstractListModel;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.ListCellRenderer;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.Card;
import simgsm.ui.ComponentNames;
import simgsm.ui.CopiedText;
import simgsm.ui.Drawing;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simgsm.ui.VerticalScrollPane;
import simrobot.control.LoggedEvent;
import simrobot.drawing.NumberTexts;
import simrobot.ui.ToolButtons;
import simrobot.ui.WrappedText;

/** The event log of all robots or of the selected one, newest at the bottom; lines can be copied. */
public final class EventsCard extends JPanel {
    private final TextBundle texts;
    private final EventTexts words;
    private final Rows model = new Rows();
    private final JList<LoggedEvent> list = new JList<>(model) {
        @Override
        public String getToolTipText(MouseEvent event) {
            int row = locationToIndex(event.getPoint());
            return row < 0 ? null : words.of(model.rows.get(row).line());
        }
    };

    /** The selected event in full; list rows are truncated. */
    private final WrappedText whole;

    private final JScrollPane pane = new VerticalScrollPane(list);
    private final JCheckBox onlySelected;
    private List<LoggedEvent> events = List.of();
    private String selected = "";
    private List<LoggedEvent> filtered = List.of();
    private String filteredFor = "";

    EventsCard(TextBundle texts) {
        super(new BorderLayout());
        setOpaque(false);
        this.texts = texts;
        words = new EventTexts(texts);
        ComponentNames.name(list, "events", texts.of("log.title"));
        list.setToolTipText(texts.of("log.whole"));
        list.setCellRenderer(new RowRenderer());
        whole = new WrappedText("events.whole", texts.of("log.whole"), Ink.TEXT);
        list.addListSelectionListener(chosen -> whole.show(
                list.isSelectionEmpty() ? "" : words.of(list.getSelectedValue().line())));
        onlySelected = new JCheckBox(texts.of("log.only"));
        onlySelected.setOpaque(false);
        onlySelected.addActionListener(event -> filter());
        ComponentNames.name(onlySelected, "events.only", texts.of("log.only"));
        UserAction copy =
                new UserAction("events.copy", texts.of("log.copy"), this::copy).described(texts.of("log.copy.hint"));
        copy.bind(list, JComponent.WHEN_FOCUSED, KeyStroke.getKeyStroke(KeyEvent.VK_C, InputEvent.CTRL_DOWN_MASK));
        JPanel tools = Arrange.row(Theme.HALF, onlySelected, Arrange.spring(), ToolButtons.named(new JButton(), copy));
        add(new Card(texts.of("log.title"), Arrange.column(Theme.GRID, tools, Arrange.growing(pane), whole)));
    }

    void show(List<LoggedEvent> newest, String robot) {
        events = newest;
        selected = robot;
        update();
    }

    /** Filters the log only if visible. */
    private void update() {
        if (isVisible() && (events != filtered || !selected.equals(filteredFor))) {
            filter();
        }
    }

    @Override
    public void setVisible(boolean visible) {
        super.setVisible(visible);
        update();
    }

    /** Filters the log; a list that shows its end keeps showing it. */
    private void filter() {
        filtered = events;
        filteredFor = selected;
        var bar = pane.getVerticalScrollBar();
        boolean atEnd = bar.getValue() + bar.getVisibleAmount() >= bar.getMaximum() - Theme.px(4);
        List<LoggedEvent> chosen = list.getSelectedValuesList();
        boolean grown = model.show(
                onlySelected.isSelected()
                        ? events.stream()
                                .filter(event -> event.robot().equals(selected))
                                .toList()
                        : events);
        if (!grown) {
            select(chosen);
        }
        if (atEnd && model.getSize() > 0 && list.getSelectedIndex() < 0) {
            list.ensureIndexIsVisible(model.getSize() - 1);
        }
    }

    /** Selects these events in their new rows, if they still exist. */
    private void select(List<LoggedEvent> chosen) {
        list.clearSelection();
        chosen.stream()
                .mapToInt(model.rows::indexOf)
                .filter(row -> row >= 0)
                .forEach(row -> list.addSelectionInterval(row, row));
    }

    /** The selected lines, or all. */
    public String copied() {
        List<LoggedEvent> chosen = list.getSelectedValuesList();
        return (chosen.isEmpty() ? model.rows : chosen)
                .stream().map(words::line).collect(Collectors.joining("\n", "", "\n"));
    }

    private void copy() {
        if (!CopiedText.copy(copied())) {
            whole.show(texts.of("log.copy.busy"));
        }
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(Theme.px(180), Theme.px(160));
    }

    /** The log grows at its end, so existing rows are not announced again. */
    private static final class Rows extends AbstractListModel<LoggedEvent> {
        private List<LoggedEvent> rows = List.of();

        /** @return true if the previous rows are unchanged */
        boolean show(List<LoggedEvent> newRows) {
            int before = rows.size();
            boolean grown =
                    newRows.size() >= before && (before == 0 || newRows.get(before - 1) == rows.get(before - 1));
            rows = newRows;
            if (!grown) {
                fireContentsChanged(this, 0, Math.max(before, newRows.size()));
            } else if (newRows.size() > before) {
                fireIntervalAdded(this, before, newRows.size() - 1);
            }
            return grown;
        }

        @Override
        public int getSize() {
            return rows.size();
        }

        @Override
        public LoggedEvent getElementAt(int index) {
            return rows.get(index);
        }
    }

    /** Two lines: time and robot, then the event. */
    private final class RowRenderer extends PaintedComponent implements ListCellRenderer<LoggedEvent> {
        private LoggedEvent event;
        private boolean chosen;

        RowRenderer() {
            super(AccessibleRole.LABEL);
            setName("event");
        }

        @Override
        public Component getListCellRendererComponent(
                JList<? extends LoggedEvent> owner, LoggedEvent value, int index, boolean isSelected, boolean focus) {
            change(() -> event = value);
            chosen = isSelected;
            return this;
        }

        @Override
        protected String spoken() {
            return event == null ? "" : words.line(event).replace('\t', ' ');
        }

        @Override
        public Dimension getPreferredSize() {
            return new Dimension(Theme.px(120), Theme.px(36));
        }

        @Override
        protected void paint(Graphics2D g, double width, double height) {
            if (chosen) {
                g.setColor(Theme.color(Ink.ACCENT_WASH));
                g.fillRect(0, 0, getWidth(), getHeight());
            }
            double left = Theme.exact(8);
            String time = NumberTexts.clock(event.timeNanos());
            g.setColor(Theme.color(Ink.QUIET));
            g.setFont(Theme.monoSmall());
            g.drawString(time, (float) left, Theme.exact(14));
            double nameAt = left + Drawing.width(Theme.monoSmall(), time) + Theme.exact(8);
            g.setFont(Theme.small());
            g.drawString(
                    Drawing.fitted(Theme.small(), event.robot(), width - nameAt - left),
                    (float) nameAt,
                    Theme.exact(14));
            g.setColor(Theme.color(Ink.TEXT));
            g.setFont(Theme.base());
            g.drawString(
                    Drawing.fitted(Theme.base(), words.of(event.line()), width - 2 * left),
                    (float) left,
                    Theme.exact(30));
        }
    }
}
