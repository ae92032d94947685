package blackbox;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * A session with a centre, phones and robots, each a process of its own. Its steps are printed; closing it ends
 * all processes and clears its folder.
 */
public class Scenario implements AutoCloseable {
    public static final String ROBOT = "5550200";
    public static final String PHONE = "5550100";

    private final Path folder;
    private final List<RunningProgram> programs = new ArrayList<>();
    private final List<Process> beside = new ArrayList<>();
    private String center = "";
    /** Where terminals connect: the centre, or the cells before it. */
    private String network = "";

    private ConsoleEvent ready;

    public Scenario(String title) {
        try {
            folder = Files.createTempDirectory("simgsm-scenario");
        } catch (IOException e) {
            throw new AssertionError(e);
        }
        tell("== " + title);
    }

    /** Says what happens next. */
    public void tell(String step) {
        System.out.println("  " + step);
    }

    /** Starts any program. */
    public RunningProgram start(String name, String program, String... arguments) {
        return start(name, Map.of(), program, arguments);
    }

    /** Starts any program with something more in its environment. */
    public RunningProgram start(String name, Map<String, String> environment, String program, String... arguments) {
        return run(name, environment, Dist.command(program, List.of(arguments)));
    }

    /** Starts a program as users do, by {@code java -jar} alone. */
    public RunningProgram startJar(String name, Map<String, String> environment, String program, String... arguments) {
        List<String> command = new ArrayList<>(
                List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-jar"));
        command.add(Dist.jar(program).toString());
        command.addAll(List.of(arguments));
        return run(name, environment, command);
    }

    private RunningProgram run(String name, Map<String, String> environment, List<String> command) {
        try {
            RunningProgram started = new RunningProgram(name, command, folder, environment);
            programs.add(started);
            return started;
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    /** Takes a program that was written elsewhere into the scenario, whose end ends it with all that it started. */
    public Process beside(Process program) {
        beside.add(program);
        return program;
    }

    RunningProgram headless(String name, String program, List<String> first, String... more) {
        return headless(name, Map.of(), program, first, more);
    }

    private RunningProgram headless(
            String name, Map<String, String> environment, String program, List<String> first, String... more) {
        List<String> arguments = new ArrayList<>(List.of("--headless", "--lang", "en", "--no-sound"));
        arguments.addAll(first);
        arguments.addAll(List.of(more));
        return start(name, environment, program, arguments.toArray(String[]::new));
    }

    /** Starts the centre on a free port and waits until it is ready. */
    public RunningProgram center(String... options) {
        return centerOn("0", options);
    }

    /** Starts the centre again on the port it had. */
    public RunningProgram centerAgain(String... options) {
        return centerOn(center.substring(center.lastIndexOf(':') + 1), options);
    }

    /** Starts the centre on a free port, with something more in its environment. */
    RunningProgram centerIn(Map<String, String> environment, String... options) {
        return centerOn("0", environment, options);
    }

    private RunningProgram centerOn(String port, String... options) {
        return centerOn(port, Map.of(), options);
    }

    private RunningProgram centerOn(String port, Map<String, String> environment, String... options) {
        Path data = folder.resolve("data");
        RunningProgram program = headless(
                "centre", environment, "simgsm-center", List.of("--port", port, "--data", data.toString()), options);
        ready = program.expect("ready");
        center = "127.0.0.1:" + ready.field("port");
        network = center;
        return program;
    }

    /** Puts the cells of a town before the centre; phones and robots that start later connect there. */
    public RunningProgram cells(String town, String... options) {
        RunningProgram cells = headless(
                "cells",
                "simgsm-cells",
                List.of("--center", center, "--port", "0", "--town", world(town).toString()),
                options);
        network = "127.0.0.1:" + cells.expect("ready").field("port");
        return cells;
    }

    /** Starts a gateway for browsers on a free port. */
    public RunningProgram gateway(String... options) {
        List<String> arguments = new ArrayList<>(
                List.of("--headless", "--lang", "en", "--center", network, "--web", "0", "--key", "word"));
        arguments.addAll(List.of(options));
        return start("gateway", "simgsm-gateway", arguments.toArray(String[]::new));
    }

    /** Starts a gateway for these SIP phones alone, all with the password {@code secret}; {@code ready} names its port. */
    public RunningProgram sipGateway(List<String> numbers) throws IOException {
        Path data = Files.createDirectories(folder.resolve("gateway"));
        List<String> lines = numbers.stream().map(number -> number + "=secret").toList();
        Files.write(data.resolve("sip-users.properties"), lines);
        return start(
                "gateway",
                "simgsm-gateway",
                "--headless",
                "--lang",
                "en",
                "--center",
                network,
                "--sip",
                "0",
                "--data",
                data.toString());
    }

    /** Starts a gateway for mail alone, with the service number 6245 and the domain sms.example. @param server port of a mail server */
    public RunningProgram mailGateway(int server) {
        return start(
                "gateway",
                "simgsm-gateway",
                "--headless",
                "--lang",
                "en",
                "--smpp",
                "127.0.0.1:" + smppPort(),
                "--mail-number",
                "6245",
                "--mail-domain",
                "sms.example",
                "--mail-to",
                "127.0.0.1:" + server,
                "--mail-in",
                "0");
    }

    /** Starts a gateway for fax alone, with the service number 6329. @param smsc port of an SMSC */
    public RunningProgram faxGateway(int smsc, Path faxes) {
        return start(
                "gateway",
                "simgsm-gateway",
                "--headless",
                "--lang",
                "en",
                "--smpp",
                "127.0.0.1:" + smsc,
                "--fax-number",
                "6329",
                "--fax",
                faxes.toString());
    }

    /** Where the centre, started with {@code --smpp}, takes applications. */
    public int smppPort() {
        return Integer.parseInt(ready.field("smpp"));
    }

    /** Where the centre, started with {@code --http}, answers by HTTP. */
    public String centerUrl() {
        return "http://127.0.0.1:" + ready.field("http") + "/";
    }

    /** Starts a phone and waits until it is registered. */
    public RunningProgram phone(String number, String... options) {
        RunningProgram phone = unregisteredPhone(number, options);
        phone.expect("registered", "number", number);
        return phone;
    }

    /** Starts a phone without waiting for its registration. */
    public RunningProgram unregisteredPhone(String number, String... options) {
        RunningProgram phone =
                headless("phone-" + number, "simgsm-phone", List.of("--center", network, "--number", number), options);
        phone.expect("ready");
        return phone;
    }

    /** Starts SimRobot with a world of ours, answering calls at once, and waits until its modem is registered. */
    public RunningProgram robot(String world, String... options) {
        RunningProgram robot = unregisteredRobot(world, options);
        robot.expect("registered");
        return robot;
    }

    /** Starts SimRobot without waiting for its modem's registration. */
    RunningProgram unregisteredRobot(String world, String... options) {
        RunningProgram robot = headless(
                "robot",
                "simrobot",
                List.of(
                        "--center",
                        network,
                        "--number",
                        ROBOT,
                        "--world",
                        world(world).toString(),
                        "--answer-after",
                        "0"),
                options);
        robot.expect("ready");
        return robot;
    }

    public static Path world(String name) {
        return Dist.root().resolve("worlds").resolve(name);
    }

    /** A call from the phone to the robot, up to the tone that accepts it. */
    public void call(RunningProgram phone) {
        phone.say("dial " + ROBOT);
        phone.expect("connected", "number", ROBOT);
        phone.expectNext("tone", "key", "1");
    }

    public Path folder() {
        return folder;
    }

    public String centerAddress() {
        return center;
    }

    @Override
    public void close() throws IOException {
        programs.forEach(RunningProgram::close);
        // A program that ends may still remove its files, so the folder is cleared when all have ended.
        List<ProcessHandle> ending = beside.stream()
                .flatMap(program -> Stream.concat(Stream.of(program.toHandle()), program.descendants()))
                .toList();
        ending.forEach(ProcessHandle::destroy);
        ending.forEach(program -> program.onExit()
                .orTimeout(RunningProgram.PATIENCE_SECONDS, TimeUnit.SECONDS)
                .join());
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.deleteIfExists(file);
            }
        }
    }
}
