package simrobot.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import simgsm.air.Msisdn;
import simgsm.audio.SoundCard;
import simgsm.console.Arguments;
import simgsm.console.Options;
import simgsm.console.UsageException;
import simgsm.modem.ModemOptions;
import simgsm.modem.VoiceStore;
import simgsm.sim.InsertedCard;
import simgsm.sim.SimSlot;
import simgsm.speech.AudioOutput;
import simgsm.speech.SpeechCodec;
import simgsm.words.Prompts;
import simgsm.words.SpokenLanguage;
import simrobot.control.Fleet;
import simrobot.control.RobotConsole;
import simrobot.process.BehaviourKind;
import simrobot.source.ChildSettings;
import vericommand.VeriCommandSettings;

/** SimRobot's options and their values. */
public final class SimRobotOptions {
    private static final double MIN_SPEED = 0.001;
    private static final double MAX_SPEED = 1000;

    private SimRobotOptions() {}

    public static Options all() {
        return Options.read(SimRobotOptions.class.getResourceAsStream("options.txt"))
                .commands(RobotConsole.COMMANDS);
    }

    /** Simulated seconds per second; 0 starts paused. */
    public static double speed(Arguments arguments) throws UsageException {
        boolean isPaused = arguments.has("speed") && arguments.number("speed", 1, 0, MAX_SPEED) == 0;
        return isPaused ? 0 : arguments.number("speed", 1, MIN_SPEED, MAX_SPEED);
    }

    /** @param single true if there is one robot; its calls are recorded in the named file itself */
    public static Fleet.Kit kit(Arguments arguments, SimSlot slot, boolean single, long seed, BehaviourKind behaviour)
            throws UsageException, IOException {
        Optional<String> pin = RequestedRobots.pin(arguments);
        boolean power = arguments.choice("power", "on", "off").equals("on");
        boolean motors = arguments.choice("motors", "on", "off").equals("on");
        CallRecordings recordings = new CallRecordings(arguments.path("record-audio"), single);
        return new Fleet.Kit(
                seed,
                power,
                motors,
                behaviour,
                arguments.value("codec", SpeechCodec.Kind::named).orElse(SpeechCodec.Kind.A_LAW),
                (int) arguments.integer(
                        "answer-after",
                        ModemOptions.DEFAULT_ANSWER_AFTER_MILLIS,
                        0,
                        ModemOptions.MAX_ANSWER_AFTER_MILLIS),
                prompts(arguments),
                voices(arguments),
                recordings,
                number -> {
                    Optional<InsertedCard> card = Arguments.checked(() -> slot.card(Optional.of(number)));
                    card.ifPresent(inserted -> pin.ifPresent(inserted::enter));
                    return card;
                });
    }

    /** The prompts of {@code --speak} in the program's language; recordings of {@code --prompts} replace some. */
    private static Optional<Prompts> prompts(Arguments arguments) throws UsageException {
        Optional<Path> folder = arguments.path("prompts");
        if (folder.isPresent() && !arguments.has("speak") && !arguments.has("voice")) {
            throw new UsageException("--prompts: expected with --speak or --voice");
        }
        if (folder.isPresent() && !Files.isDirectory(folder.get())) {
            throw new UsageException("--prompts: expected a folder, found " + folder.get());
        }
        SpokenLanguage language = SpokenLanguage.of(arguments.language());
        return arguments.has("speak") || arguments.has("voice")
                ? Optional.of(Arguments.checked(() -> new Prompts(language, name -> recording(folder, name))))
                : Optional.empty();
    }

    /** Callers' templates in the folder {@code voices} of {@code --data}, one folder a number. */
    private static Optional<VoiceStore> voices(Arguments arguments) throws UsageException {
        if (!arguments.has("voice")) {
            return Optional.empty();
        }
        Path data = arguments.path("data").orElseThrow(() -> new UsageException("--voice: expected with --data DIR"));
        return Optional.of(new CallerVoices(data.resolve("voices")));
    }

    /** The file {@code NAME.gsm} of the folder, if there is one. */
    private static Optional<byte[]> recording(Optional<Path> folder, String name) {
        Optional<Path> file = folder.map(in -> in.resolve(name + ".gsm")).filter(Files::exists);
        try {
            return file.isPresent() ? Optional.of(Files.readAllBytes(file.get())) : Optional.empty();
        } catch (IOException e) {
            throw new IllegalArgumentException("prompt " + name + ": " + e.getMessage(), e);
        }
    }

    /** Settings of the processes of {@code --behaviours}. */
    public static ChildSettings children(Arguments arguments) throws UsageException {
        return ChildSettings.of(
                (int) arguments.integer(
                        "behaviour-memory",
                        ChildSettings.DEFAULT_MEBIBYTES,
                        ChildSettings.MIN_MEBIBYTES,
                        ChildSettings.MAX_MEBIBYTES),
                arguments.language());
    }

    /** Opens the output: a window shows at once if there is no device; a console opens it with the first sound. */
    public static AudioOutput sound(Arguments arguments) {
        if (arguments.has("no-sound")) {
            return AudioOutput.SILENT;
        }
        return arguments.has("headless") ? SoundCard.openWhenPlayed() : SoundCard.open();
    }

    /** The given seed, else a random one. */
    public static long seed(Arguments arguments) throws UsageException {
        return arguments.has("seed")
                ? arguments.integer("seed", 0, Long.MIN_VALUE, Long.MAX_VALUE)
                : new Random().nextLong();
    }

    /** The commanders, the language of answers, and the handling of a motion after its call is lost. */
    public static VeriCommandSettings settings(Arguments arguments) throws UsageException {
        Set<String> operators =
                arguments.value("operators", SimRobotOptions::operators).orElse(Set.of());
        VeriCommandSettings.OnHangup onHangup =
                arguments.choice("on-hangup", "stop", "finish").equals("stop")
                        ? VeriCommandSettings.OnHangup.STOP
                        : VeriCommandSettings.OnHangup.FINISH;
        boolean isPaid = arguments.has("modem");
        String answered = arguments.choice("reply", isPaid ? "orders" : "all", isPaid ? "all" : "orders", "none");
        return new VeriCommandSettings(
                arguments.language(),
                operators,
                onHangup,
                VeriCommandSettings.Answered.valueOf(answered.toUpperCase(Locale.ROOT)));
    }

    private static Set<String> operators(String list) {
        Set<String> numbers = new HashSet<>();
        for (String item : list.split(",", -1)) {
            String number = item.strip();
            String digits = Msisdn.parse(number.replaceFirst("\\*$", "")).digits();
            numbers.add(number.endsWith("*") ? digits + "*" : digits);
        }
        return numbers;
    }
}
