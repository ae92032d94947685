package blackbox.uml;

import blackbox.VirtualPhone;
import blackbox.VirtualSuite;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.center.msc.BroadcastOrder;
import simgsm.center.subscriber.HomeRegister;
import simgsm.octets.OctetString;
import simgsm.sim.SimCard;
import simgsm.sim.Subscription;
import simgsm.station.mobility.Sim;

/** Sequences, each recorded from a run of the real exchange, phones, modem, verifier and robot with a clock moved by hand. */
class SequenceDiagramsTest {
    private static final String OTHER = "5550101";
    private static final String OPERATOR = "actor Operator";
    private static final String PHONE = "participant \"Phone (M1)\\n5550100\" as M1";
    private static final String CENTER = "participant \"Centre (M3)\" as M3";
    private static final String MODEM = "participant \"Modem (M2)\\n5550200\" as M2";
    private static final String VERICOMMAND = "participant VeriCommand";
    private static final String ROBOT = "participant Robot";

    @TempDir
    Path folder;

    private final SequenceTrace trace =
            new SequenceTrace().terminal(VirtualSuite.PHONE, "M1").terminal(VirtualSuite.ROBOT, "M2");

    private VirtualSuite suite() {
        return new VirtualSuite(trace, HomeRegister.OPEN, Optional.empty());
    }

    private VirtualPhone phone(VirtualSuite suite) {
        VirtualPhone phone = suite.phone(VirtualSuite.PHONE);
        trace.user(phone, "M1");
        return phone;
    }

    @Test
    void callSetUp() throws Exception {
        VirtualSuite suite = suite();
        VirtualPhone phone = phone(suite);
        trace.begin();
        trace.arrow("Operator", "M1", "dials 5550200");
        phone.dial(VirtualSuite.ROBOT);
        suite.seconds(2.5);
        trace.arrow("Operator", "M1", "hangs up");
        phone.hangUp();
        suite.seconds(0.5);
        hold("call", "A call: set-up, tone 1, clearing", OPERATOR, PHONE, CENTER, MODEM);
    }

    @Test
    void orderByTone() throws Exception {
        VirtualSuite suite = suite();
        VirtualPhone phone = phone(suite);
        phone.dial(VirtualSuite.ROBOT);
        suite.seconds(2.5);
        trace.wheels(suite.robot);
        trace.begin();
        trace.arrow("Operator", "M1", "keys **#**20**");
        phone.press("** #**20 **");
        suite.seconds(4);
        hold(
                "order-by-tone",
                "An order by tone, from the key to the wheels and back",
                OPERATOR,
                PHONE,
                CENTER,
                MODEM,
                VERICOMMAND,
                ROBOT,
                "participant Wheels");
    }

    @Test
    void orderByMessage() throws Exception {
        VirtualSuite suite = new VirtualSuite(trace, HomeRegister.OPEN, Optional.of(folder));
        VirtualPhone phone = phone(suite);
        trace.begin();
        trace.arrow("Operator", "M1", "SMS ** #*#90 ** to 5550200");
        phone.message(VirtualSuite.ROBOT, "** #*#90 **");
        suite.seconds(6);
        hold(
                "order-by-sms",
                "An order by SMS: stored on disk before it is acknowledged",
                OPERATOR,
                PHONE,
                CENTER,
                "participant Journal",
                "database Disk",
                MODEM,
                VERICOMMAND,
                ROBOT);
    }

    @Test
    void recoveryAfterKill() throws Exception {
        trace.terminal(OTHER, "Other").terminal(VirtualSuite.ROBOT, null);
        VirtualSuite suite = new VirtualSuite(trace, HomeRegister.OPEN, Optional.of(folder));
        VirtualPhone phone = phone(suite);
        VirtualPhone other = suite.phone(OTHER);
        trace.user(other, "Other");
        other.station().powerOff();
        suite.seconds(1);
        trace.begin();
        trace.arrow("Operator", "M1", "SMS hello to 5550101, which is switched off");
        phone.message(OTHER, "hello");
        suite.seconds(1);
        trace.add("== kill -9 of the centre; it is started again ==");
        suite.restartCenter();
        trace.add("== the other phone is switched on ==");
        other.station().powerOn();
        suite.seconds(3);
        hold(
                "recovery",
                "Recovery after kill -9: an acknowledged message is delivered",
                OPERATOR,
                PHONE,
                CENTER,
                "participant Journal",
                "database Disk",
                "participant \"Other phone\\n5550101\" as Other");
    }

    @Test
    void broadcast() throws Exception {
        VirtualSuite suite = suite();
        phone(suite);
        trace.begin();
        trace.arrow("Operator", "M3", "broadcast 50 The lesson begins.");
        BroadcastOrder order = BroadcastOrder.once(50, "The lesson begins.");
        trace.inAnyOrder(() -> suite.exchange().broadcast(suite.nowNanos(), order));
        suite.seconds(0.5);
        hold("broadcast", "Cell broadcast: one page to every attached terminal", OPERATOR, CENTER, PHONE, MODEM);
    }

    @Test
    void authentication() throws Exception {
        SimCard card = new SimCard(
                new Imsi("001010005550100"),
                new Msisdn(VirtualSuite.PHONE),
                OctetString.ofHex("465b5ce8b199b49faa5f0a2ee238a6bc"),
                OctetString.ofHex("cd63cb71954a9f4e48a5994e37a02baf"));
        HomeRegister home = HomeRegister.closed(List.of(new Subscription(card, false)), Set.of());
        VirtualSuite suite = new VirtualSuite(trace, home, Optional.empty());
        trace.terminal(VirtualSuite.ROBOT, null);
        trace.begin();
        trace.add("== a phone with the listed card ==");
        suite.phone(VirtualSuite.PHONE, Sim.of(card));
        suite.seconds(0.5);
        trace.add("== a phone with another key ==");
        SimCard wrong = new SimCard(
                card.imsi(), card.number(), card.opc().orElseThrow(), card.opc().orElseThrow());
        suite.phone(VirtualSuite.PHONE, Sim.of(wrong));
        suite.seconds(0.5);
        hold("authentication", "Registration in a closed network (TS 24.008, 4.3.2; TS 35.206)", PHONE, CENTER);
    }

    private void hold(String name, String title, String... participants) throws Exception {
        Diagram.hold("design/sequence-" + name + ".puml", trace.plantUml(title, participants));
    }
}
