package simgsm.classroom.demo;

import java.net.SocketException;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import simgsm.air.Msisdn;
import simgsm.center.app.CenterSettings;
import simgsm.classroom.session.Session;
import simgsm.console.HostPort;
import simgsm.console.UsageException;
import simgsm.net.ReachableAddresses;

/** The students of a class, counted from 0: their numbers, their robots, and the commands of their machines. */
final class ClassRoll {
    private static final long FIRST_PHONE = Long.parseLong(Session.PHONE_NUMBER);
    private static final long FIRST_ROBOT = Long.parseLong(Session.ROBOT_NUMBER);

    private final int students;
    private final CenterSettings settings;
    private final List<String> hosts;

    ClassRoll(int students, CenterSettings settings) throws SocketException {
        this.students = students;
        this.settings = settings;
        hosts = ReachableAddresses.of(settings.address());
    }

    int students() {
        return students;
    }

    static String name(int student) {
        return "robot" + (student + 1);
    }

    String phone(int student) {
        return Long.toString(FIRST_PHONE + student);
    }

    /** The teacher's phone has the number after the last student's. */
    String teacher() {
        return phone(students);
    }

    String robot(int student) {
        return Long.toString(FIRST_ROBOT + student);
    }

    /** Numbers of all students, then of all robots. */
    Stream<String> numbers() {
        return Stream.concat(
                IntStream.range(0, students).mapToObj(this::phone),
                IntStream.range(0, students).mapToObj(this::robot));
    }

    /** A closed network must list the SIMs of all students and robots. */
    void requireCards() throws UsageException {
        if (!settings.home().isClosed()) {
            return;
        }
        List<String> missing = numbers()
                .filter(number -> !settings.home().numbers().contains(new Msisdn(number)))
                .toList();
        if (!missing.isEmpty()) {
            throw new UsageException("--class: expected SIMs of " + String.join(", ", missing) + " in "
                    + settings.home().file().get());
        }
    }

    /** The addresses of the centre, most likely first. */
    List<String> hosts() {
        return hosts;
    }

    /** The command that starts a student's phone. */
    String command(String number, String host, int port) {
        String card = settings.home().isClosed() ? " --sim " + number + ".sim" : "";
        return "java -jar simgsm-phone.jar --number " + number + " --center " + new HostPort(host, port) + card;
    }
}
