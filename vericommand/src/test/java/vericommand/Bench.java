package vericommand;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/** A verifier over a hand-driven robot that writes down all it sends and tells. */
final class Bench implements VeriCommandListener {
    static final String CALLER = "5550100";

    final HandDrivenRobot robot;
    final VeriCommand veri;
    private final List<String> told = new ArrayList<>();

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

    Bench call() {
        veri.callBegan(CALLER);
        return this;
    }

    void press(String keys) {
        OrderText.keysOf(keys).chars().forEach(key -> veri.key((char) key));
    }

    void sms(String text) {
        veri.message("5550101", text);
    }

    /** What has been told since the last time; {@code told("tone")} keeps only lines of that kind. */
    List<String> told(String... kinds) {
        List<String> lines = told.stream()
                .filter(line ->
                        kinds.length == 0 || List.of(kinds).contains(line.substring(0, (line + " ").indexOf(' '))))
                .toList();
        told.clear();
        return lines;
    }

    @Override
    public void tone(ReplyTone tone) {
        told.add("tone " + tone.key());
    }

    @Override
    public void clearCall() {
        told.add("clear");
    }

    @Override
    public void message(String to, String text) {
        told.add("sms " + to + " " + text);
    }

    @Override
    public void underWay(boolean underWay) {
        told.add("under-way " + underWay);
    }

    @Override
    public void order(String keys, Verdict verdict) {
        told.add("order " + keys + " " + verdict.word());
    }

    @Override
    public void instructionEnded(Instruction instruction) {
        told.add("ended " + instruction.keys());
    }

    @Override
    public void outcome(Reply reply) {
        told.add("outcome " + reply.message());
    }

    @Override
    public void senderIgnored(String from) {
        told.add("ignored " + from);
    }
}
