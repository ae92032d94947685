package vericommand;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/** A verifier with a hand-driven robot; records all output. */
final class Bench implements VeriCommandListener {
    static final String CALLER = "5550100";

    final HandDrivenRobot robot;
    final VeriCommand veri;
    private final List<String> events = new ArrayList<>();
    /** The snapshot at the last change: what a window shows. */
    VeriCommandSnapshot shown;

    int changes;
    long nowNanos;

    private Bench(RobotStatus status, VeriCommandSettings settings) {
        robot = new HandDrivenRobot(status);
        veri = new VeriCommand(robot, settings, this);
    }

    static Bench in(RobotStatus status) {
        return new Bench(status, VeriCommandSettings.DEFAULT);
    }

    static Bench with(VeriCommandSettings settings) {
        return new Bench(RobotStatus.STOPPED, settings);
    }

    static VeriCommandSettings settings(VeriCommandSettings.OnHangup onHangup, String... operators) {
        return new VeriCommandSettings(Locale.ENGLISH, Set.of(operators), onHangup);
    }

    /** In status Moving by an autonomous behaviour. */
    static Bench autonomous() {
        Bench bench = in(RobotStatus.MOVING);
        bench.robot.autonomous = true;
        return bench;
    }

    Bench call() {
        veri.callBegan(CALLER);
        return this;
    }

    void press(String keys) {
        OrderText.keysOf(keys).chars().forEach(key -> veri.key((char) key));
    }

    void sms(String text) {
        sms("5550101", text);
    }

    void sms(String from, String text) {
        veri.message(from, text, nowNanos);
    }

    /** The output since the last call; {@code events("tone")} keeps only lines of that kind. */
    List<String> events(String... kinds) {
        List<String> lines = events.stream()
                .filter(line ->
                        kinds.length == 0 || List.of(kinds).contains(line.substring(0, (line + " ").indexOf(' '))))
                .toList();
        events.clear();
        return lines;
    }

    @Override
    public void tone(ReplyTone tone) {
        events.add("tone " + tone.key());
    }

    @Override
    public void clearCall() {
        events.add("clear");
    }

    @Override
    public void message(String to, String text) {
        events.add("sms " + to + " " + text);
        assertTrue(ReplyForms.isReply(text), text);
    }

    @Override
    public void underWay(boolean underWay) {
        events.add("under-way " + underWay);
    }

    @Override
    public void order(String keys, Verdict verdict) {
        events.add("order " + keys + " " + verdict.word());
    }

    @Override
    public void instructionEnded(Instruction instruction) {
        events.add("ended " + instruction.keys());
    }

    @Override
    public void outcome(Reply reply) {
        events.add("outcome " + reply.message());
    }

    @Override
    public void senderIgnored(String from) {
        events.add("ignored " + from);
    }

    @Override
    public void replyIgnored(String from) {
        events.add("reply-ignored " + from);
    }

    @Override
    public void senderSilenced(String from) {
        events.add("silenced " + from);
    }

    @Override
    public void changed() {
        changes++;
        shown = veri.snapshot();
    }
}
