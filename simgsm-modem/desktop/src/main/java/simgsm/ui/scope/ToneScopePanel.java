package simgsm.ui.scope;

import java.awt.BorderLayout;
import java.util.Locale;
import java.util.function.Consumer;
import javax.swing.JPanel;
import simgsm.dtmf.ToneExperiment;
import simgsm.dtmf.ToneTrace;
import simgsm.ui.Arrange;
import simgsm.ui.Theme;

/** The tone scope of phone and modem; below it the receivers with their candidate keys, and the experiment. */
public final class ToneScopePanel extends JPanel {
    /** In units: below it the two sliders lie one below the other. */
    private static final int NARROW = 440;
    /** In units: in a lower compact scope the row of the receiver is hidden. */
    private static final int LOW = 174;

    private final ToneScope scope;
    private final ReceiverPanel receivers;
    private final ToneExperimentBar experiment;
    private boolean isCompact;

    /**
     * A scope that shows nothing yet.
     *
     * @param chosen receives each experiment that is set, on the event thread; the scope's owner passes it to its tracer
     */
    public ToneScopePanel(Locale language, Consumer<ToneExperiment> chosen) {
        super(new BorderLayout());
        setOpaque(false);
        setName("scope");
        scope = new ToneScope(language);
        experiment = new ToneExperimentBar(language, chosen);
        add(scope, BorderLayout.CENTER);
        receivers = new ReceiverPanel(language, this::select);
        add(Arrange.column(Theme.HALF, receivers, experiment), BorderLayout.SOUTH);
    }

    private void select(ShownReceiver receiver) {
        scope.show(receiver);
        experiment.show(receiver);
    }

    /** A compact scope is lower, has one receiver's row and no sliders; their settings remain in effect. */
    public void setCompact(boolean compact) {
        scope.setCompact(compact);
        receivers.setCompact(compact);
        experiment.setVisible(!compact);
        isCompact = compact;
    }

    @Override
    public void doLayout() {
        experiment.arrange(getWidth() < Theme.px(NARROW));
        receivers.setVisible(!isCompact || getHeight() >= Theme.px(LOW));
        super.doLayout();
    }

    public void show(ToneTrace trace) {
        scope.show(trace);
        receivers.show(trace);
        experiment.show(trace);
    }
}
