package simrobot.ui.telephone;

import java.awt.BorderLayout;
import java.util.Locale;
import java.util.function.Consumer;
import javax.swing.JLabel;
import javax.swing.JPanel;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.draw.StatusMark;
import simgsm.station.StationSnapshot;
import simgsm.station.call.MobileCallTable.MobileCallState;
import simgsm.tone.ToneExperiment;
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
public final class ModemPanel extends JPanel {
    /** The height of the compact panel below the floor. */
    public static final int COMPACT_HEIGHT_UNITS = 156;

    private final TextBundle texts;
    private final Card card;
    private final JPanel page = new JPanel(new BorderLayout());
    private boolean isCompact;
    private boolean isStacked;
    private final TextLine number = new TextLine("modem.number", () -> Theme.mono(18, true), Ink.TEXT);
    private final TextLine network = new TextLine("modem.network", Theme::base, Ink.QUIET);
    private final SignalBars signal;
    private final Lamp call;
    private final TextLine peer = new TextLine("modem.peer", Theme::monoStrong, Ink.TEXT).ofDigits();
    private final TextLine codec = new TextLine("modem.codec", Theme::small, Ink.QUIET);
    private final JLabel sound = ComponentNames.name(Theme.label("", Theme::small, Ink.QUIET), "modem.sound", "");
    private final ToneScopePanel scope;
    private final OperatorActions operator;
    /** Shared by all robots. */
    private ToneExperiment experiment = ToneExperiment.NONE;

    private String robot = "";
    private final Locale language;

    public ModemPanel(TextBundle texts, Locale language, OperatorActions operator) {
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
        page.setOpaque(false);
        card = new Card(texts.of("modem.title"), page);
        add(card, BorderLayout.CENTER);
        place();
    }

    /**
     * Selects the form for the size of the page.
     *
     * @param compact without title and sliders
     * @param stacked number and call above the tone scope, instead of all facts at its left
     */
    public void arrange(boolean compact, boolean stacked) {
        if (compact != isCompact || stacked != isStacked) {
            isCompact = compact;
            isStacked = stacked;
            place();
            revalidate();
        }
    }

    private void place() {
        page.removeAll();
        if (isStacked) {
            JPanel facts = Arrange.row(10, number, call, Arrange.growing(peer), signal);
            page.add(Arrange.column(6, facts, Arrange.growing(scope)));
        } else {
            JPanel facts = Arrange.column(
                    6,
                    Arrange.row(10, number, Arrange.spring(), signal),
                    network,
                    call,
                    Arrange.row(0, Arrange.growing(peer)), // stays marked when it has been stacked
                    codec,
                    Arrange.row(0, sound, Arrange.spring()),
                    Arrange.spring());
            page.add(Arrange.row(16, facts, Arrange.growing(scope)));
        }
        card.setTitleVisible(!isCompact);
        scope.setCompact(isCompact);
    }

    public void show(TelephoneSnapshot line) {
        StationSnapshot modem = line.modem();
        number.show(line.number());
        network.show(network(modem));
        signal.show(modem.signalBars(SignalBars.BARS));
        showCall(modem);
        peer.show(modem.peer().map(Msisdn::digits).orElse(""));
        codec.show(CodecText.of(modem.codec(), modem.heardCodec(), language));
        showSound(line.audible());
        robot = line.robot();
        if (!line.heard().experiment().equals(experiment)) {
            operator.tryOut(robot, experiment);
        }
        scope.show(line.heard());
    }

    /** @param listener receives true to hide keys in the window, false to show them */
    public void whenHidingKeys(Consumer<Boolean> listener) {
        scope.whenHiding(listener);
    }

    private String network(StationSnapshot modem) {
        if (modem.rejectCause().isPresent()) {
            return refusal(modem);
        }
        if (!modem.registered() || modem.networkName().isEmpty()) {
            return texts.of("modem.noNetwork");
        }
        return modem.cell()
                .map(cell -> texts.of(
                        "modem.cell", modem.networkName(), String.valueOf(cell.identity()), String.valueOf(cell.dbm())))
                .orElse(modem.networkName());
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

    /**
     * Shows the call, or, in a panel too narrow for the network's line, a refusal: without a network there is no call.
     */
    private void showCall(StationSnapshot modem) {
        MobileCallState state = modem.callState();
        if (isStacked && modem.rejectCause().isPresent()) {
            call.show(StatusMark.SLASHED_RING, Ink.DANGER, refusal(modem));
        } else if (state == MobileCallState.NULL) {
            call.show(StatusMark.RING, Ink.QUIET, texts.of("modem.call.none"));
        } else if (state == MobileCallState.ACTIVE) {
            call.show(StatusMark.DISC, Ink.GOOD, texts.of("modem.call.active"));
        } else if (state == MobileCallState.CALL_RECEIVED) {
            call.show(StatusMark.HALF_DISC, Ink.WARNING, texts.of("modem.call.ringing"));
        } else {
            call.show(StatusMark.HALF_DISC, Ink.WARNING, texts.of("modem.call.setup"));
        }
    }

    public static LinkState linkState(StationSnapshot modem) {
        if (!modem.powered()) {
            return LinkState.OFF;
        }
        if (modem.registered()) {
            return LinkState.UP;
        }
        return modem.rejectCause().isPresent() ? LinkState.REFUSED : LinkState.SEARCHING;
    }
}
