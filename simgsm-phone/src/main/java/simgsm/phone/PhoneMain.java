package simgsm.phone;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Optional;
import java.util.function.Consumer;
import simgsm.audio.Microphone;
import simgsm.audio.SoundCard;
import simgsm.console.Arguments;
import simgsm.console.Console;
import simgsm.console.Event;
import simgsm.console.ExitStatus;
import simgsm.console.HostPort;
import simgsm.console.Options;
import simgsm.console.Program;
import simgsm.console.TextBundle;
import simgsm.console.UnavailableException;
import simgsm.console.UsageException;
import simgsm.modem.at.AtProfile;
import simgsm.modem.at.port.AtPort;
import simgsm.phone.ui.HandsetWindow;
import simgsm.speech.AudioInput;
import simgsm.speech.AudioOutput;
import simgsm.station.context.StationEvent;
import simgsm.ui.window.ProgramWindow;
import simgsm.ui.window.StartErrorWindow;
import simgsm.ui.window.WindowMemory;
import simgsm.ui.window.WindowOptions;

/** Starts a phone, with its window or on a console. */
public final class PhoneMain {
    static final String NAME = "simgsm-phone";
    private static final int MAX_PORT = 0xffff;
    private static final HostPort DEFAULT_CENTER = new HostPort("127.0.0.1", 3003);

    private PhoneMain() {}

    public static void main(String[] args) {
        new Program(NAME, options())
                .showingErrors(StartErrorWindow::show, "headless")
                .checking(WindowOptions::check)
                .runAndExit(args, PhoneMain::run);
    }

    static Options options() {
        return Options.read(PhoneMain.class.getResourceAsStream("options.txt")).commands(PhoneCommands.TABLE);
    }

    static int run(Arguments given) throws Exception {
        Arguments arguments = WindowMemory.recall(given, "phone");
        PhoneOptions options = PhoneOptions.of(arguments);
        HostPort center = arguments.hostPort("center").orElse(DEFAULT_CENTER);
        TextBundle texts = PhoneTexts.in(arguments.language());
        return arguments.has("headless")
                ? headless(arguments, options, center, texts)
                : windowed(arguments, options, center);
    }

    static InetSocketAddress address(HostPort center) {
        return new InetSocketAddress(center.host(), center.port());
    }

    /** A window shows if a sound device exists, so it opens one at once; a console opens it with the first sound. */
    private static AudioOutput sound(Arguments arguments) {
        if (arguments.has("no-sound")) {
            return AudioOutput.SILENT;
        }
        return arguments.has("headless") ? SoundCard.openWhenPlayed() : SoundCard.open();
    }

    private static AudioInput microphone(Arguments arguments) throws UnavailableException {
        try {
            return arguments.has("microphone") ? Microphone.open() : AudioInput.SILENT;
        } catch (IOException e) {
            throw new UnavailableException("--microphone: " + e.getMessage());
        }
    }

    /** Opens the port for AT commands, if requested, and adds it to the first event. */
    private static Event withAtPort(Arguments arguments, Phone phone, Event ready) throws UsageException, IOException {
        if (!arguments.has("at")) {
            if (arguments.has("at-audio")) {
                throw new UsageException("--at-audio: expected with --at PORT");
            }
            return ready;
        }
        AtProfile profile = arguments.value("at-profile", AtProfile::named).orElse(AtProfile.PLAIN);
        AtPort port = phone.openAtPort(atAddress(arguments, "at"), profile);
        Event withAt = ready.with("at", port.port());
        return arguments.has("at-audio")
                ? withAt.with("at-audio", port.openAudio(atAddress(arguments, "at-audio")))
                : withAt;
    }

    private static InetSocketAddress atAddress(Arguments arguments, String option) throws UsageException {
        return new InetSocketAddress(InetAddress.getLoopbackAddress(), (int) arguments.integer(option, 0, 0, MAX_PORT));
    }

    private static int windowed(Arguments arguments, PhoneOptions options, HostPort center)
            throws UsageException, UnavailableException, IOException, InterruptedException {
        ProgramWindow window = ProgramWindow.of(arguments, Optional.empty());
        Optional<Console> console =
                arguments.has("console") ? Optional.of(Console.onStandardOutput()) : Optional.empty();
        TextBundle texts = PhoneTexts.in(arguments.language());
        Consumer<StationEvent> printer =
                console.isPresent() ? new PhoneEventPrinter(console.get(), texts) : event -> {};
        Phone phone = new Phone(options, printer, sound(arguments), microphone(arguments));
        Event ready = withAtPort(arguments, phone, Event.of("ready"));
        Runtime.getRuntime().addShutdownHook(new Thread(phone::close, "detach"));
        phone.start(address(center));
        console.ifPresent(out -> out.ready(ready));
        window.onLessonBeside(name -> BegunLesson.start(
                name,
                arguments,
                fields -> phone.execute(() -> phone.handset().userCodes().result(fields))));
        console.ifPresent(out -> window.withConsole(out, arguments, new PhoneCommands(out, phone)));
        try (PhoneControls controls = new PhoneControls(phone)) {
            window.show(new HandsetWindow(PhoneTexts::in, phone.handset()::snapshot, controls, window::speak)::content);
        }
        phone.close();
        console.ifPresent(Console::close);
        return ExitStatus.OK;
    }

    private static int headless(Arguments arguments, PhoneOptions options, HostPort center, TextBundle texts)
            throws IOException, InterruptedException, UsageException, UnavailableException {
        try (Console console = Console.onStandardOutput();
                Phone phone = new Phone(
                        options, new PhoneEventPrinter(console, texts), sound(arguments), microphone(arguments))) {
            PhoneCommands commands = new PhoneCommands(console, phone);
            Runtime.getRuntime().addShutdownHook(new Thread(phone::close, "detach"));
            Event ready = withAtPort(arguments, phone, Event.of("ready"));
            phone.start(address(center));
            console.ready(ready);
            Program.runConsole(console, arguments, commands);
            commands.finish();
            return console.exitStatus();
        }
    }
}
