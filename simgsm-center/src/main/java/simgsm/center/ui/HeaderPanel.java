package simgsm.center.ui;

import java.awt.BorderLayout;
import java.util.Locale;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.ui.Act;
import simgsm.ui.Arrange;
import simgsm.ui.Lamp;
import simgsm.ui.Mark;
import simgsm.ui.Named;
import simgsm.ui.Symbol;
import simgsm.ui.Texts;
import simgsm.ui.Theme;
import simgsm.ui.Theme.Ink;
import simgsm.ui.WindowKeys;

/** Name, port, what is going on in numbers, and the way out. */
final class HeaderPanel extends JPanel {
    private final Texts texts;
    private final JLabel title = new JLabel("SMSyCT");
    private final JLabel network = new JLabel();
    private final NetworkAccess access;
    private final Lamp port;
    private final Lamp attached;
    private final Lamp calls;
    private final Lamp waiting;
    private final RatesLabel rateLabel = new RatesLabel();
    private final Rates rates = new Rates();

    HeaderPanel(Texts texts, CenterActions operator) {
        super(new BorderLayout());
        this.texts = texts;
        setOpaque(false);
        port = lamp("lamp.port", "window.port.name");
        attached = lamp("lamp.attached", "window.attached.name");
        calls = lamp("lamp.calls", "window.calls");
        waiting = lamp("lamp.waiting", "window.waiting.name");
        access = operator.access();
        String accessKey = "window.network." + access.name().toLowerCase(Locale.ROOT);
        network.setText(texts.of(accessKey));
        network.setToolTipText(texts.of(accessKey + ".why"));
        network.setName("network");
        Act appearance = new Act("window.appearance", "", () -> WindowKeys.switchAppearance(this))
                .described(texts.of("window.appearance.why"))
                .with(Symbol.SUN_MOON.icon());
        Act quit =
                new Act("window.quit", texts.of("window.quit"), operator::quit).described(texts.of("window.quit.why"));
        add(
                Arrange.row(
                        16,
                        title,
                        port,
                        network,
                        Arrange.growing(rateLabel),
                        attached,
                        calls,
                        waiting,
                        Arrange.row(
                                8,
                                Named.name(
                                        new JButton(appearance),
                                        "window.appearance",
                                        texts.of("window.appearance.why")),
                                Named.name(new JButton(quit), "window.quit", texts.of("window.quit.why")))),
                BorderLayout.CENTER);
        port.show(Mark.DISC, Ink.GOOD, texts.of("window.port", String.valueOf(operator.port())));
        Named.name(rateLabel, "rates", texts.of("window.rates.name"));
        rateLabel.setToolTipText(texts.of("window.rates.why"));
        showCounts(0, 0, 0);
        showRates();
        dress();
    }

    private Lamp lamp(String name, String subjectKey) {
        Lamp lamp = new Lamp(texts.of(subjectKey));
        lamp.setName(name);
        return lamp;
    }

    void tick(long nowNanos) {
        rates.tick(nowNanos);
        showRates();
    }

    private void showRates() {
        rateLabel.setText(texts.of("window.rates", rates.messagesPerSecond(), rates.framesPerSecond()));
    }

    void show(ExchangeSnapshot snapshot) {
        rates.saw(snapshot);
        showCounts(snapshot.attached(), snapshot.calls().size(), snapshot.waiting());
    }

    private void showCounts(int attachedCount, int callCount, int waitingCount) {
        attached.show(
                attachedCount > 0 ? Mark.DISC : Mark.RING,
                attachedCount > 0 ? Ink.GOOD : Ink.QUIET,
                texts.of("window.count.attached", attachedCount));
        calls.show(
                callCount > 0 ? Mark.ARROW : Mark.RING,
                callCount > 0 ? Ink.ACCENT : Ink.QUIET,
                texts.of("window.count.calls", callCount));
        waiting.show(
                waitingCount > 0 ? Mark.DIAMOND : Mark.RING,
                waitingCount > 0 ? Ink.WARNING : Ink.QUIET,
                texts.of("window.count.waiting", waitingCount));
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (title != null) {
            dress();
        }
    }

    private void dress() {
        title.setFont(Theme.sans(20, true));
        network.setForeground((access == NetworkAccess.OPEN_TO_OTHERS ? Ink.WARNING : Ink.QUIET).color());
        rateLabel.setForeground(Ink.QUIET.color());
    }
}
