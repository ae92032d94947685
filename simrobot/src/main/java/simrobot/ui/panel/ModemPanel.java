package simrobot.ui.panel;

import java.awt.BorderLayout;
import java.util.Locale;
import javax.swing.JLabel;
import javax.swing.JPanel;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.draw.StatusMark;
import simgsm.dtmf.ToneExperiment;
import simgsm.station.StationSnapshot;
import simgsm.station.call.MobileCallState;
import simgsm.ui.Arrange;
import simgsm.ui.Card;
import simgsm.ui.ComponentNames;
import simgsm.ui.Lamp;
import simgsm.ui.LinkState;
import simgsm.ui.SignalBars;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.scope.CodecText;
import simgsm.ui.scope.ToneScopePanel;
import simrobot.ui.OperatorActions;
import simrobot.ui.TelephoneSnapshot;
import simrobot.ui.TextLine;

/** M2: its number, the network, the call, and the tone scope. */
final class ModemPanel extends JPanel {
    private static final int NARROW_UNITS = 440;

    private final TextBundle texts;
    private final TextLine number = new TextLine("modem.number", () -> Theme.mono(18, true), Ink.TEXT);
    private final TextLine network = new TextLine("modem.network", Theme::base, Ink.QUIET);
    private final SignalBars signal;
    private final Lamp call;
    private final TextLine peer = new TextLine("modem.peer", Theme::monoStrong, Ink.TEXT);
    private final TextLine codec = new TextLine("modem.codec", Theme::small, Ink.QUIET);
    private final JLabel sound = ComponentNames.name(Theme.label("", Theme::small, Ink.QUIET), "modem.sound", "");
    private final JPanel facts;
    private final JPanel secondary;
    private final BorderLayout contentLayout = new BorderLayout();
    private final JPanel content = new JPanel(contentLayout);
    private final ToneScopePanel scope;
    private boolean compact;
    private final OperatorActions operator;
    /** The same for all robots. */
    private ToneExperiment experiment = ToneExperiment.NONE;

    private String robot = "";
    private final Locale language;

    ModemPanel(TextBundle texts, Locale language, OperatorActions operator) {
        super(new BorderLayout());
        this.texts = texts;
        this.language = language;
        this.operator = operator;
        setOpaque(false);
        signal =
                ComponentNames.name(new SignalBars(texts.of("modem.signal")), "modem.signal", texts.of("modem.signal"));
        call = new Lamp(texts.of("modem.call"));
        call.setName("modem.call");
        scope = new ToneScopePanel(language, this::tryOut);
        secondary = Arrange.column(6, codec, Arrange.row(0, sound, Arrange.spring()), Arrange.spring());
        JPanel numberRow = Arrange.row(10, number, Arrange.spring(), signal);
        facts = Arrange.column(6, numberRow, network, call, peer, Arrange.growing(secondary));
        content.setOpaque(false);
        content.add(scope, BorderLayout.CENTER);
        content.add(facts, BorderLayout.WEST);
        Card card = new Card(texts.of("modem.title"), content);
        add(card, BorderLayout.CENTER);
    }

    void show(TelephoneSnapshot line) {
        StationSnapshot modem = line.modem();
        number.show(line.number());
        network.show(network(modem));
        signal.show(modem.registered() ? SignalBars.BARS : 0);
        showCall(modem.callState());
        peer.show(modem.peer().map(Msisdn::digits).orElse(""));
        codec.show(CodecText.of(modem.codec(), modem.heardCodec(), language));
        showSound(line.audible());
        robot = line.robot();
        if (!line.heard().experiment().equals(experiment)) {
            operator.tryOut(robot, experiment);
        }
        scope.show(line.heard());
    }

    private String network(StationSnapshot modem) {
        if (modem.rejectCause().isPresent()) {
            return refusal(modem);
        }
        return modem.registered() && !modem.networkName().isEmpty() ? modem.networkName() : texts.of("modem.noNetwork");
    }

    private String refusal(StationSnapshot modem) {
        if (modem.cardRefused()) {
            return texts.of("modem.refused.card");
        }
        RejectCause cause = modem.rejectCause().orElseThrow();
        return switch (cause) {
            // the centre rejects a second terminal with a number in use by "illegal MS"
            case ILLEGAL_MS -> texts.of("modem.refused.taken");
            case IMSI_UNKNOWN_IN_HLR -> texts.of("modem.refused.unknown");
            case ILLEGAL_ME -> texts.of("modem.refused.equipment");
            case PLMN_NOT_ALLOWED -> texts.of("modem.refused.barred");
            case CONGESTION -> texts.of("modem.refused.congestion");
            case NETWORK_FAILURE -> texts.of("modem.refused.failure");
            default -> texts.of("modem.refused.other", String.valueOf(cause.code()));
        };
    }

    /** Puts the facts beside the scope or, where that leaves too little room for it, the first of them above. */
    @Override
    public void doLayout() {
        boolean narrow = !compact && getWidth() < Theme.px(NARROW_UNITS);
        if (narrow == secondary.isVisible()) {
            network.setVisible(!narrow);
            secondary.setVisible(!narrow);
            content.add(facts, narrow ? BorderLayout.NORTH : BorderLayout.WEST);
        }
        contentLayout.setHgap(Theme.px(16));
        super.doLayout();
    }

    /** @param wanted without the tone scope's sliders, and lower */
    void setCompact(boolean wanted) {
        compact = wanted;
        scope.setCompact(wanted);
    }

    private void tryOut(ToneExperiment chosen) {
        experiment = chosen;
        if (!robot.isEmpty()) {
            operator.tryOut(robot, chosen);
        }
    }

    private void showSound(boolean audible) {
        String words = texts.of(audible ? "modem.sound.on" : "modem.sound.off");
        if (!words.equals(sound.getToolTipText())) {
            sound.setIcon((audible ? Symbol.SPEAKER : Symbol.SPEAKER_OFF).icon());
            sound.setText(audible ? "" : words);
            sound.setToolTipText(words);
            sound.getAccessibleContext().setAccessibleName(words);
        }
    }

    private void showCall(MobileCallState state) {
        if (state == MobileCallState.NULL) {
            call.show(StatusMark.RING, Ink.QUIET, texts.of("modem.call.none"));
        } else if (state == MobileCallState.ACTIVE) {
            call.show(StatusMark.DISC, Ink.GOOD, texts.of("modem.call.active"));
        } else if (state == MobileCallState.CALL_RECEIVED) {
            call.show(StatusMark.HALF_DISC, Ink.WARNING, texts.of("modem.call.ringing"));
        } else {
            call.show(StatusMark.HALF_DISC, Ink.WARNING, texts.of("modem.call.setup"));
        }
    }

    static LinkState linkState(StationSnapshot modem) {
        if (!modem.powered()) {
            return LinkState.OFF;
        }
        if (modem.registered()) {
            return LinkState.UP;
        }
        return modem.rejectCause().isPresent() ? LinkState.REFUSED : LinkState.SEARCHING;
    }
}
