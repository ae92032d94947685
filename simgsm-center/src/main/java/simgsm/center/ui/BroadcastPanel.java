package simgsm.center.ui;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.KeyboardFocusManager;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSpinner;
import javax.swing.JTextArea;
import javax.swing.SpinnerNumberModel;
import simgsm.center.msc.BroadcastOrder;
import simgsm.center.msc.BroadcastView;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.sms.BroadcastSerial;
import simgsm.sms.CellBroadcast;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.DocumentChanges;
import simgsm.ui.DressedPanel;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simgsm.ui.VerticalScrollPane;
import simgsm.ui.pane.ScrolledColumn;

/**
 * Cell broadcast: channel, language, repetition, text and number of pages; below, the repeated broadcasts, which can be
 * stopped.
 */
final class BroadcastPanel extends DressedPanel {
    /** The default channel of phones: area names (050). */
    private static final int FIRST_CHANNEL = 50;

    private static final int MAX_CHANNEL = 0xffff;
    private static final int RUNNING_UNITS = 110;
    /** Two lines of text, also in a low window. */
    private static final int LEAST_TEXT_UNITS = 42;
    /** Six lines, so that the button stays next to the text in a high window. */
    private static final int MOST_TEXT_UNITS = 112;
    /** Room for five digits. */
    private static final int NUMBER_COLUMNS = 4;
    /** Channels of public warnings: 3GPP TS 23.041 clause 9.4.1.2.2. */
    private static final int FIRST_WARNING = 4352;

    private static final int LAST_WARNING = 6399;

    /** The first one names none. */
    private static final String[] LANGUAGES = {
        "-", "en", "es", "de", "fr", "it", "pt", "nl", "sv", "da", "fi", "no", "el", "tr", "hu", "pl", "cs", "he", "ar",
        "ru", "is"
    };

    private static final BroadcastSerial ANY_SERIAL = new BroadcastSerial(BroadcastSerial.NETWORK_WIDE, 0, 0);

    private final TextBundle texts;
    private final CenterActions operator;
    private final Background background;
    private final JSpinner channel = new JSpinner(new SpinnerNumberModel(FIRST_CHANNEL, 0, MAX_CHANNEL, 1));
    private final JTextArea text;
    private final JScrollPane field;
    private final JLabel pages = new JLabel();
    private final JLabel result = new JLabel(" ");
    private final JLabel channelName = new JLabel();
    private final JPanel form;
    private final JComboBox<String> language = new JComboBox<>(LANGUAGES);
    private final JSpinner times = new JSpinner(new SpinnerNumberModel(1, 0, BroadcastOrder.MOST_TIMES, 1));
    private final JSpinner period = new JSpinner(new SpinnerNumberModel(
            (int) BroadcastOrder.DEFAULT_PERIOD.toSeconds(), 1, (int) BroadcastOrder.LONGEST_PERIOD.toSeconds(), 1));
    private final RowsPanel<BroadcastView> running;
    private final UserAction send;
    private final UserAction stop;
    private final JButton stopButton;
    /** The result of the latest broadcast and the button that stops one; hidden when both are absent. */
    private final JPanel outcome;

    BroadcastPanel(TextBundle texts, CenterActions operator, Background background) {
        this.texts = texts;
        this.operator = operator;
        this.background = background;
        setOpaque(false);
        send = UserAction.of(texts, "broadcast.send", "window.broadcast.send", this::send)
                .with(Symbol.BROADCAST.icon());
        text = new HintedTextArea(texts.of("window.broadcast.text"));
        field = new JScrollPane(text);
        nameFields();
        running = Tables.broadcasts(texts).onChoice(row -> lookAtChoice());
        running.setVisible(false);
        stop = UserAction.of(texts, "broadcast.stop", "window.broadcast.stop", this::stop);
        stop.setEnabled(false);
        stopButton = ComponentNames.name(new JButton(stop), "broadcast.stop", texts.of("window.broadcast.stop"));
        stopButton.setVisible(false);
        outcome = Arrange.row(8, Arrange.growing(result), stopButton);
        outcome.setVisible(false);
        form = form();
        add(new VerticalScrollPane(new ScrolledColumn(form)).bare(), BorderLayout.CENTER);
        text.getDocument().addDocumentListener(new DocumentChanges(this::count));
        dress();
    }

    private void nameFields() {
        text.setToolTipText(texts.of("window.broadcast.text"));
        for (JSpinner number : List.of(channel, times, period)) {
            JSpinner.NumberEditor editor = new JSpinner.NumberEditor(number, "0");
            editor.getTextField().setColumns(NUMBER_COLUMNS);
            number.setEditor(editor);
        }
        name(channelName, "broadcast.channel.name", "window.broadcast.channel.name");
        channel.addChangeListener(event -> nameChannel());
        nameChannel();
        name(channel, "broadcast.channel", "window.broadcast.channel");
        name(language, "broadcast.language", "window.broadcast.language.name");
        name(times, "broadcast.times", "window.broadcast.times.name");
        name(period, "broadcast.period", "window.broadcast.period.name");
        name(text, "broadcast.text", "window.broadcast.text");
        name(pages, "broadcast.pages", "window.broadcast.pages.name");
        name(result, "broadcast.result", "window.broadcast.result");
        text.setLineWrap(true);
        text.setWrapStyleWord(true);
        // Tab moves the focus.
        text.setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
        text.setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
        language.addActionListener(event -> count());
    }

    private void name(JComponent component, String id, String key) {
        ComponentNames.name(component, id, texts.of(key));
    }

    private JPanel form() {
        JPanel rest = new JPanel(new BorderLayout());
        rest.setOpaque(false);
        rest.add(running, BorderLayout.CENTER);
        JButton sendButton =
                ComponentNames.name(new JButton(send), "broadcast.send", texts.of("window.broadcast.send"));
        return Arrange.column(
                8,
                Arrange.row(
                        8,
                        labelled("channel", channel),
                        channel,
                        Arrange.growing(channelName),
                        labelled("language", language),
                        language),
                Arrange.row(8, labelled("times", times), times, labelled("period", period), period, Arrange.spring()),
                field,
                Arrange.row(8, Arrange.growing(pages), sendButton),
                outcome,
                Arrange.growing(rest));
    }

    /** Names the content of known channels; empty for others. */
    private void nameChannel() {
        int number = (Integer) channel.getValue();
        String name = number == FIRST_CHANNEL
                ? texts.of("window.broadcast.channel.area")
                : number >= FIRST_WARNING && number <= LAST_WARNING ? texts.of("window.broadcast.channel.warning") : "";
        channelName.setText(name);
        channelName.setToolTipText(name.isEmpty() ? null : name);
    }

    /** Gives the text the remaining height, within its bounds. */
    @Override
    public void doLayout() {
        int others = form.getPreferredSize().height - field.getPreferredSize().height;
        int spare = getHeight() - getInsets().top - getInsets().bottom - others;
        int height = Math.max(Theme.px(LEAST_TEXT_UNITS), Math.min(Theme.px(MOST_TEXT_UNITS), spare));
        if (height != field.getPreferredSize().height) {
            field.setPreferredSize(new Dimension(0, height));
            form.revalidate();
        }
        super.doLayout();
    }

    private JLabel labelled(String key, JComponent field) {
        JLabel label = new JLabel(texts.of("window.broadcast." + key));
        label.setLabelFor(field);
        return label;
    }

    /** Shows the repeated broadcasts; without any the text uses their space. */
    void show(List<BroadcastView> broadcasts) {
        if (running.isVisible() == broadcasts.isEmpty()) {
            running.setVisible(!broadcasts.isEmpty());
            stopButton.setVisible(!broadcasts.isEmpty());
            showOutcome();
        }
        running.show(broadcasts);
        lookAtChoice();
    }

    private void showOutcome() {
        outcome.setVisible(stopButton.isVisible() || !result.getText().isBlank());
        revalidate();
    }

    private void lookAtChoice() {
        stop.setEnabled(running.selected().isPresent());
    }

    private void stop() {
        running.selected()
                .ifPresent(chosen -> background.run(
                        () -> operator.stopBroadcast(chosen.id()),
                        failure -> failure.ifPresent(cause -> showResult(cause.getMessage(), Ink.DANGER))));
    }

    private BroadcastOrder order() {
        int count = (Integer) times.getValue();
        return new BroadcastOrder(
                (Integer) channel.getValue(),
                text.getText(),
                chosenLanguage(),
                Duration.ofSeconds((Integer) period.getValue()),
                count == 0 ? OptionalInt.empty() : OptionalInt.of(count),
                OptionalInt.empty());
    }

    private Optional<String> chosenLanguage() {
        return language.getSelectedIndex() == 0 ? Optional.empty() : Optional.of((String) language.getSelectedItem());
    }

    private void send() {
        String written = text.getText();
        BroadcastOrder order;
        try {
            order = order();
        } catch (IllegalArgumentException invalid) {
            showResult(invalid.getMessage(), Ink.DANGER);
            return;
        }
        send.setEnabled(false);
        background.run(() -> operator.broadcast(order), failure -> {
            if (failure.isPresent()) {
                showResult(failure.get().getMessage(), Ink.DANGER);
            } else {
                showResult(texts.of("window.broadcast.sent", String.valueOf(order.channel())), Ink.GOOD);
                if (text.getText().equals(written)) {
                    text.setText("");
                }
            }
            count();
        });
    }

    private void showResult(String words, Ink ink) {
        result.setText(words);
        result.setForeground(Theme.color(ink));
        showOutcome();
    }

    /** Shows the number of pages; disables sending if the text is too long or empty. */
    private void count() {
        String written = text.getText();
        try {
            int count = CellBroadcast.split(written, 0, ANY_SERIAL, chosenLanguage())
                    .size();
            pages.setText(texts.of("window.broadcast.pages", written.length(), count));
            pages.setForeground(Theme.color(Ink.QUIET));
            send.setEnabled(!written.isBlank());
        } catch (IllegalArgumentException tooLong) {
            pages.setText(texts.of("window.broadcast.tooLong"));
            pages.setForeground(Theme.color(Ink.DANGER));
            send.setEnabled(false);
        }
    }

    @Override
    protected void dress() {
        setBorder(Theme.padding(6, 4, 0, 4));
        pages.setFont(Theme.small());
        channelName.setFont(Theme.small());
        channelName.setForeground(Theme.color(Ink.QUIET));
        Dimension least = new Dimension(0, Theme.px(LEAST_TEXT_UNITS));
        field.setMinimumSize(least);
        field.setPreferredSize(least);
        running.setPreferredSize(new Dimension(0, Theme.px(RUNNING_UNITS)));
        result.setFont(Theme.base());
        result.setForeground(Theme.color(Ink.QUIET));
        count();
    }
}
