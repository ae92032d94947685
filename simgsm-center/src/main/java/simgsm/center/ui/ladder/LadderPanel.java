package simgsm.center.ui.ladder;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.JTextArea;
import javax.swing.JToggleButton;
import javax.swing.ScrollPaneConstants;
import javax.swing.SwingUtilities;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.console.TextBundle;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/** The GSM messages between terminals and centre, live; below, the fields of the selected message. */
final class LadderPanel extends JPanel {
    private static final Dimension LIST_UNITS = new Dimension(560, 240);
    private static final Dimension DETAIL_UNITS = new Dimension(540, 150);

    private static final int LOW_UNITS = 330;
    /** The ladder's share of the width when the message is next to it. */
    private static final double LADDER_SHARE = 0.58;

    private final TextBundle texts;
    private final LadderModel model = new LadderModel();
    private final LadderCell cell = new LadderCell();
    private final LifelineHeader header = new LifelineHeader();
    private final LadderList list;
    private final JTextArea detail = new JTextArea();
    private final JLabel heading = new JLabel();
    private final JLabel title = new JLabel();
    private final JComboBox<String> who = new JComboBox<>();
    private final JToggleButton follow;
    private final JPanel detailPane;
    private final JSplitPane split;
    private List<String> terminals = List.of();

    LadderPanel(TextBundle texts) {
        super(new BorderLayout());
        this.texts = texts;
        list = new LadderList(model, cell, texts.of("window.ladder.empty"));
        setOpaque(false);
        follow = ComponentNames.name(
                new JToggleButton(new UserAction("ladder.follow", texts.of("window.ladder.follow"), this::followed)
                        .described(texts.of("window.ladder.follow.why"))
                        .with(Symbol.FOLLOW.icon())),
                "ladder.follow",
                texts.of("window.ladder.follow"));
        follow.setSelected(true);
        detailPane = makeDetailPane();
        detailPane.setVisible(false);
        split = new JSplitPane(JSplitPane.VERTICAL_SPLIT, listPane(), detailPane);
        split.setResizeWeight(1);
        split.setBorder(null);
        split.setOpaque(false);
        add(tools(), BorderLayout.NORTH);
        add(split, BorderLayout.CENTER);
        list.addListSelectionListener(event -> chosen(list.getSelectedIndex()));
        who.addActionListener(event -> filter());
        updateChoice();
        dress();
    }

    private JPanel tools() {
        UserAction clear = new UserAction("ladder.clear", texts.of("window.ladder.clear"), this::clear)
                .described(texts.of("window.ladder.clear.why"))
                .with(Symbol.ERASE.icon());
        ComponentNames.name(who, "ladder.who", texts.of("window.ladder.who"));
        heading.setText(texts.of("window.ladder"));
        JPanel row = Arrange.row(
                12,
                Arrange.growing(heading),
                who,
                follow,
                ComponentNames.name(new JButton(clear), "ladder.clear", texts.of("window.ladder.clear")));
        row.setBorder(Theme.padding(0, 0, 8, 0));
        return row;
    }

    private JScrollPane listPane() {
        ComponentNames.name(list, "ladder.list", texts.of("window.ladder.name"));
        JScrollPane pane = new JScrollPane(
                list,
                ScrollPaneConstants.VERTICAL_SCROLLBAR_ALWAYS,
                ScrollPaneConstants.HORIZONTAL_SCROLLBAR_AS_NEEDED);
        pane.setColumnHeaderView(header);
        pane.setPreferredSize(new Dimension(Theme.px(LIST_UNITS.width), Theme.px(LIST_UNITS.height)));
        pane.setMinimumSize(new Dimension(0, 0));
        pane.getVerticalScrollBar().addAdjustmentListener(event -> {
            if (event.getValueIsAdjusting()) {
                follow.setSelected(isAtEnd(pane));
            }
        });
        return pane;
    }

    private static boolean isAtEnd(JScrollPane pane) {
        var bar = pane.getVerticalScrollBar().getModel();
        return bar.getValue() + bar.getExtent() >= bar.getMaximum() - Theme.px(LadderCell.HEIGHT_UNITS);
    }

    /** Hidden until a message is selected. */
    private JPanel makeDetailPane() {
        detail.setEditable(false);
        detail.setLineWrap(true);
        detail.setWrapStyleWord(true);
        ComponentNames.name(detail, "ladder.detail", texts.of("window.ladder.detail"));
        JPanel pane = new JPanel(new BorderLayout());
        pane.setOpaque(false);
        pane.add(ComponentNames.name(title, "ladder.title", texts.of("window.ladder.detail")), BorderLayout.NORTH);
        pane.add(new JScrollPane(detail), BorderLayout.CENTER);
        pane.setPreferredSize(new Dimension(Theme.px(DETAIL_UNITS.width), Theme.px(DETAIL_UNITS.height)));
        pane.setMinimumSize(new Dimension(0, 0));
        return pane;
    }

    void show(ExchangeSnapshot snapshot) {
        int before = model.getSize();
        model.update(snapshot.ladder(), snapshot.ladderCount());
        refreshLines();
        if (follow.isSelected() && (model.getSize() != before || before > 0)) {
            showEnd();
        }
    }

    private void refreshLines() {
        List<String> now = model.terminals();
        if (!now.equals(terminals)) {
            terminals = now;
            updateChoice();
            showLines();
        }
    }

    private void showLines() {
        Optional<String> only = chosen();
        Lifelines lifelines = Lifelines.of(only.map(List::of).orElse(terminals));
        cell.show(lifelines);
        header.show(lifelines);
        list.fit();
    }

    /** Keeps the selection when numbers are added or removed. */
    private void updateChoice() {
        List<String> sorted = new ArrayList<>(terminals);
        sorted.sort(String::compareTo);
        List<String> present = new ArrayList<>();
        for (int i = 1; i < who.getItemCount(); i++) {
            present.add(who.getItemAt(i));
        }
        if (who.getItemCount() > 0 && present.equals(sorted)) {
            return;
        }
        Optional<String> chosen = chosen();
        who.removeAllItems();
        who.addItem(texts.of("window.ladder.everybody"));
        sorted.forEach(who::addItem);
        chosen.filter(sorted::contains).ifPresent(who::setSelectedItem);
    }

    private Optional<String> chosen() {
        return who.getSelectedIndex() <= 0 ? Optional.empty() : Optional.of(who.getItemAt(who.getSelectedIndex()));
    }

    private void filter() {
        model.filter(chosen());
        showLines();
        followed();
    }

    /** Shows only the messages from and to this subscriber. */
    void choose(String number) {
        if (terminals.contains(number)) {
            who.setSelectedItem(number);
        }
    }

    private void clear() {
        model.clear();
        refreshLines();
        list.repaint();
    }

    private void followed() {
        if (follow.isSelected()) {
            showEnd();
        }
    }

    /** After the layout of the new rows. */
    private void showEnd() {
        SwingUtilities.invokeLater(() -> list.ensureIndexIsVisible(model.getSize() - 1));
    }

    /** Selecting an older message stops following the latest. */
    private void chosen(int index) {
        if (index >= 0 && index < model.getSize() - 1 && list.isFocusOwner()) {
            follow.setSelected(false);
        }
        showDetail();
    }

    private void showDetail() {
        LadderRow row = list.getSelectedValue();
        if (row != null) {
            String way = row.entry().from() + " → " + row.entry().to();
            title.setText(row.entry().name() + "   " + way + "   " + row.clock());
            detail.setText(MessageFields.of(row, isLow() ? MessageFields.NARROW : MessageFields.WIDE));
            detail.setCaretPosition(0);
        }
        if (detailPane.isVisible() != (row != null)) {
            detailPane.setVisible(row != null);
            dress();
            placeDetail();
        }
    }

    /** Without the heading the tools take the whole row. */
    void setHeadingVisible(boolean visible) {
        heading.setText(visible ? texts.of("window.ladder") : "");
    }

    private boolean isLow() {
        return getHeight() > 0 && getHeight() < Theme.px(LOW_UNITS);
    }

    /** Below the ladder, or next to it in a low window. */
    private void placeDetail() {
        split.setOrientation(isLow() ? JSplitPane.HORIZONTAL_SPLIT : JSplitPane.VERTICAL_SPLIT);
        if (isLow()) {
            split.setDividerLocation((int) (split.getWidth() * LADDER_SHARE));
        } else {
            split.resetToPreferredSizes();
        }
        split.validate();
        list.ensureIndexIsVisible(list.getSelectedIndex());
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (list != null) {
            dress();
        }
    }

    private void dress() {
        heading.setFont(Theme.title());
        title.setFont(Theme.strong());
        split.setDividerSize(detailPane.isVisible() ? Theme.px(Theme.GRID) : 0);
        title.setBorder(Theme.padding(8, 2, 6, 2));
        detail.setFont(Theme.monoSmall());
        list.fit();
    }
}
