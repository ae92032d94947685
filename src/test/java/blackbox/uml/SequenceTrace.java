package blackbox.uml;

import blackbox.SuiteTrace;
import blackbox.VirtualPhone;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import simgsm.abis.IpaFrame;
import simgsm.octets.OctetString;
import simgsm.trace.MessageText;
import simrobot.robot.SimulatedRobot;

/**
 * Records a run as the lines of a sequence diagram. Speech is recorded where it sounds: one arrow for a run of frames that
 * are not silent, with their number.
 */
final class SequenceTrace implements SuiteTrace {
    private static final int RTP_HEADER = 12;

    private static final Pattern FIELD = Pattern.compile("(\\w+)=(\"[^\"]*\"|\\S*)");

    /** An arrow; of speech, the frames so far. */
    private static final class Line {
        private final String text;
        private int frames;

        Line(String text) {
            this.text = text;
        }

        @Override
        public String toString() {
            return frames == 0 ? text : text + " (" + frames + " frames of 20 ms)";
        }
    }

    private final Map<String, String> terminals = new LinkedHashMap<>();
    private final Map<VirtualPhone, String> phones = new LinkedHashMap<>();
    private final Map<VirtualPhone, int[]> heard = new HashMap<>();
    private final Map<String, Line> sounding = new HashMap<>();
    private final List<Line> lines = new ArrayList<>();
    private SimulatedRobot driven;
    private double speed;
    private double change;
    private boolean isRecording;

    /** Frames of this number's link are recorded under a participant's name. */
    SequenceTrace terminal(String number, String participant) {
        terminals.put(number, participant);
        return this;
    }

    /** What this phone's user hears and reads is recorded. */
    void user(VirtualPhone phone, String participant) {
        phones.put(phone, participant);
        heard.put(phone, new int[] {phone.tones.size(), phone.messages.size()});
    }

    /** The wheels of this robot are recorded as they speed up and slow down. */
    void wheels(SimulatedRobot robot) {
        driven = robot;
    }

    void begin() {
        isRecording = true;
    }

    /** Records what has no order of its own, sorted, so that every run prints the same. */
    void inAnyOrder(Runnable run) {
        int from = lines.size();
        run.run();
        lines.subList(from, lines.size()).sort(Comparator.comparing(Line::toString));
    }

    /** Adds an arrow. */
    void arrow(String from, String to, String text) {
        add(from + " -> " + to + " : " + escaped(text));
    }

    /** Adds a line of PlantUML as it is, such as a divider. */
    void add(String line) {
        if (isRecording) {
            lines.add(new Line(line));
        }
    }

    private static String escaped(String text) {
        return text.replace("*", "~*").replace("#", "~#");
    }

    @Override
    public void frame(String terminal, boolean isUplink, IpaFrame frame) {
        String participant = terminals.get(terminal);
        if (participant == null || !isRecording) {
            return;
        }
        String arrow = isUplink ? participant + " -> M3 : " : "M3 -> " + participant + " : ";
        if (frame.stream() == IpaFrame.SPEECH) {
            speech(arrow, frame.payload());
        } else if (frame.stream() == IpaFrame.RSL) {
            add(arrow + name(frame.payload()));
        }
    }

    private void speech(String arrow, byte[] packet) {
        byte[] samples = Arrays.copyOfRange(packet, RTP_HEADER, packet.length);
        boolean isSilent = true;
        for (byte sample : samples) {
            isSilent &= sample == samples[0];
        }
        if (isSilent) {
            sounding.remove(arrow);
            return;
        }
        sounding.computeIfAbsent(arrow, key -> {
                    Line line = new Line(key + "speech: a tone");
                    lines.add(line);
                    return line;
                })
                .frames++;
    }

    private static String name(byte[] payload) {
        return MessageText.ofRsl(OctetString.of(payload), Locale.ROOT).name();
    }

    @Override
    public void stored(String from, String to, String what) {
        add(from + " -> " + to + " : " + what);
    }

    @Override
    public void robotLine(String line) {
        String event = line.substring(0, line.indexOf(' '));
        Map<String, String> fields = new HashMap<>();
        Matcher field = FIELD.matcher(line);
        while (field.find()) {
            fields.put(field.group(1), field.group(2).replace("\"", ""));
        }
        switch (event) {
            case "keys" -> arrow("M2", "VeriCommand", "key " + fields.get("keys"));
            case "sms" -> arrow("M2", "VeriCommand", "SMS " + fields.get("text"));
            case "order" ->
                arrow("VeriCommand", "VeriCommand", "order " + fields.get("text") + " " + fields.get("verdict"));
            case "status" -> arrow("Robot", "VeriCommand", "status " + fields.get("value"));
            case "outcome" -> arrow("VeriCommand", "M2", "reply " + fields.get("text"));
            case "pose" ->
                arrow(
                        "Robot",
                        "Robot",
                        fields.get("x") + " m, " + fields.get("y") + " m, " + fields.get("heading") + " degrees");
            default -> {}
        }
    }

    @Override
    public void frameTimeOver() {
        if (driven != null) {
            wheels(driven.speedMetersPerSecond());
        }
        phones.forEach((phone, participant) -> {
            int[] before = heard.get(phone);
            for (; before[0] < phone.tones.size(); before[0]++) {
                arrow(participant, "Operator", "tone " + phone.tones.get(before[0]));
            }
            for (; before[1] < phone.messages.size(); before[1]++) {
                arrow(participant, "Operator", "SMS " + phone.messages.get(before[1]));
            }
        });
    }

    private void wheels(double now) {
        double step = Math.signum(now - speed);
        if (step != 0 && step != change) {
            arrow("Robot", "Wheels", step > 0 ? "speed up" : "slow down");
        }
        change = step == 0 ? change : step;
        speed = now;
    }

    /** The diagram. */
    String plantUml(String title, String... participants) {
        return Diagram.head(title)
                + "hide footbox\n"
                + Arrays.stream(participants).map(line -> line + "\n").collect(Collectors.joining())
                + lines.stream().map(line -> line + "\n").collect(Collectors.joining())
                + "@enduml\n";
    }
}
