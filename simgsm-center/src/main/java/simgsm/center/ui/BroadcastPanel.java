package simgsm.center.ui;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.KeyboardFocusManager;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSpinner;
import javax.swing.JTextArea;
import javax.swing.SpinnerNumberModel;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import simgsm.sms.BroadcastSerial;
import simgsm.sms.CellBroadcast;
import simgsm.ui.Act;
import simgsm.ui.Arrange;
import simgsm.ui.Named;
import simgsm.ui.Symbol;
import simgsm.ui.Texts;
import simgsm.ui.Theme;
import simgsm.ui.Theme.Ink;

/** Cell broadcast: a channel, a text, how many pages it takes, and the button that sends it to everybody. */
final class BroadcastPanel extends JPanel {
    /** The channel that handsets listen to when they are new: area names (050). */
    private static final int FIRST_CHANNEL = 50;

    private static final int MAX_CHANNEL = 0xffff;
    private static final BroadcastSerial ANY_SERIAL = new BroadcastSerial(BroadcastSerial.NETWORK_WIDE, 0, 0);

    private final Texts texts;
    private final Operator operator;
    private final JSpinner channel = new JSpinner(new SpinnerNumberModel(FIRST_CHANNEL, 0, MAX_CHANNEL, 1));
    private final JTextArea text = new JTextArea();
    private final JLabel pages = new JLabel();
    private final JLabel result = new JLabel(" ");
    private final JLabel channelLabel;
    private final JLabel textLabel;
    private final Act send;

    BroadcastPanel(Texts texts, Operator operator) {
        super(new BorderLayout());
        this.texts = texts;
        this.operator = operator;
        setOpaque(false);
        send = new Act("broadcast.send", texts.of("window.broadcast.send"), this::send)
                .described(texts.of("window.broadcast.send.why"))
                .with(Symbol.BROADCAST.icon());
        channelLabel = new JLabel(texts.of("window.broadcast.channel"));
        textLabel = new JLabel(texts.of("window.broadcast.text"));
        channelLabel.setLabelFor(channel);
        textLabel.setLabelFor(text);
        channel.setEditor(new JSpinner.NumberEditor(channel, "0"));
        Named.name(channel, "broadcast.channel", texts.of("window.broadcast.channel"));
        Named.name(text, "broadcast.text", texts.of("window.broadcast.text"));
        Named.name(pages, "broadcast.pages", texts.of("window.broadcast.pages.name"));
        Named.name(result, "broadcast.result", texts.of("window.broadcast.result"));
        text.setLineWrap(true);
        text.setWrapStyleWord(true);
        // Tab leads on, as everywhere; a broadcast has no use for it.
        text.setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
        text.setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
        text.getDocument().addDocumentListener(new Counter());
        JScrollPane scroll = new JScrollPane(text);
        scroll.setPreferredSize(new Dimension(0, 0));
        add(
                Arrange.column(
                        8,
                        Arrange.row(8, channelLabel, channel, Arrange.spring(), pages),
                        textLabel,
                        Arrange.growing(scroll),
                        Arrange.row(
                                8,
                                Arrange.growing(result),
                                Named.name(new JButton(send), "broadcast.send", texts.of("window.broadcast.send")))),
                BorderLayout.CENTER);
        dress();
        count();
    }

    private void send() {
        try {
            operator.broadcast((Integer) channel.getValue(), text.getText());
            result.setText(texts.of("window.broadcast.sent", String.valueOf(channel.getValue())));
            result.setForeground(Ink.GOOD.color());
            text.setText("");
        } catch (IllegalArgumentException wrong) {
            result.setText(wrong.getMessage());
            result.setForeground(Ink.DANGER.color());
        }
    }

    /** Pages as the text grows; a text that is too long or empty cannot be sent. */
    private void count() {
        String written = text.getText();
        try {
            int count = CellBroadcast.split(written, 0, ANY_SERIAL, Optional.empty())
                    .size();
            pages.setText(texts.of("window.broadcast.pages", written.length(), count));
            pages.setForeground(Ink.QUIET.color());
            send.setEnabled(!written.isBlank());
        } catch (IllegalArgumentException tooLong) {
            pages.setText(texts.of("window.broadcast.tooLong"));
            pages.setForeground(Ink.DANGER.color());
            send.setEnabled(false);
        }
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (text != null) {
            dress();
            count();
        }
    }

    private void dress() {
        setBorder(Theme.padding(8, 4, 0, 4));
        pages.setFont(Theme.small());
        result.setFont(Theme.base());
        result.setForeground(Ink.QUIET.color());
    }

    private final class Counter implements DocumentListener {
        @Override
        public void insertUpdate(DocumentEvent event) {
            count();
        }

        @Override
        public void removeUpdate(DocumentEvent event) {
            count();
        }

        @Override
        public void changedUpdate(DocumentEvent event) {
            count();
        }
    }
}
