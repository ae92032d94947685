package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.air.Cause;
import simgsm.air.MobilityManagement;
import simgsm.air.SupplementaryService.SsFacility;
import simgsm.air.SupplementaryService.SsRegister;
import simgsm.air.SupplementaryService.SsReleaseComplete;
import simgsm.air.TransactionIdentifier;
import simgsm.octets.OctetString;
import simgsm.ss.Component;
import simgsm.ss.ComponentCodec;
import simgsm.ss.ComponentFault;
import simgsm.ss.SsError;
import simgsm.ss.SsOperation;
import simgsm.ss.SsProblem;
import simgsm.ss.UssdText;

class UssdTest {
    private static final TransactionIdentifier OURS = new TransactionIdentifier(0, false);
    private static final String REPORT = "Stopped at 0.200 -1.450 m, heading 90.0.";

    private final TestNetwork network = new TestNetwork();
    private final TestMobile phone = network.attach("5550100");

    /** Up to REGISTER with this component. */
    private void begin(OctetString facility) {
        phone.requestService(MobilityManagement.ServiceType.SUPPLEMENTARY_SERVICE);
        phone.tell(new SsRegister(OURS, facility, Optional.of(SsRegister.PHASE_2)));
    }

    private void ask(String code) {
        begin(invoke(SsOperation.PROCESS_UNSTRUCTURED_SS_REQUEST, code));
    }

    private static OctetString invoke(SsOperation operation, String text) {
        return ComponentCodec.encode(
                new Component.Invoke(1, operation, UssdText.of(text).encode()));
    }

    private static Component component(OctetString facility) {
        try {
            return ComponentCodec.decode(facility);
        } catch (ComponentFault fault) {
            throw new AssertionError(fault);
        }
    }

    /** The component with which the network ends the dialogue; it then releases the channel. */
    private Component end() {
        SsReleaseComplete complete = phone.next(SsReleaseComplete.class);
        assertEquals(OURS.answered(), complete.transaction());
        phone.leaveReleasedChannel();
        return component(complete.facility().orElseThrow());
    }

    private static Component result(String text) {
        return new Component.ReturnResult(
                1,
                SsOperation.PROCESS_UNSTRUCTURED_SS_REQUEST,
                UssdText.of(text).encode());
    }

    /** The network's question on this dialogue. @return its invoke identifier */
    private static int question(OctetString facility, String expected) {
        Component.Invoke invoke = (Component.Invoke) component(facility);
        assertTrue(invoke.is(SsOperation.UNSTRUCTURED_SS_REQUEST));
        assertEquals(UssdText.of(expected).encode(), invoke.argument());
        return invoke.id();
    }

    private static OctetString reply(int id, String text) {
        return ComponentCodec.encode(new Component.ReturnResult(
                id, SsOperation.UNSTRUCTURED_SS_REQUEST, UssdText.of(text).encode()));
    }

    @Test
    void aSubscriberGetsItsOwnNumber() {
        ask("*100#");

        assertEquals(result("5550100"), end());
    }

    @Test
    void aRobotIsPagedAndAskedAndItsReplyIsTheAnswer() {
        TestMobile robot = network.attach("5550200");
        ask("*200*5550200#");
        assertTrue(phone.hasNothing(), "the answer waits for the robot");

        robot.answerPaging();
        SsRegister asked = robot.next(SsRegister.class);
        int id = question(asked.facility(), "** #*0 **");
        TransactionIdentifier transaction = asked.transaction().answered();
        robot.tell(new SsFacility(transaction, reply(id, REPORT)));

        assertEquals(new SsReleaseComplete(asked.transaction()), robot.next(SsReleaseComplete.class));
        robot.leaveReleasedChannel();
        assertEquals(result(REPORT), end());
    }

    @Test
    void anUnknownRobotAndOneThatDoesNotAnswerPagingAreAbsent() {
        ask("*200*5550299#");
        assertEquals(result("5550299 is not registered or does not answer."), end());

        TestMobile robot = network.attach("5550200");
        ask("*200*5550200#");
        network.passSeconds(3 * 3);
        assertEquals(result("5550200 is not registered or does not answer."), end());
        robot.received.clear();
    }

    @Test
    void aRobotThatDoesNotReplyIsGivenUpAfter60Seconds() {
        TestMobile robot = network.attach("5550200");
        ask("*200*5550200#");
        robot.answerPaging();
        SsRegister asked = robot.next(SsRegister.class);
        network.passSeconds(59);
        assertTrue(robot.hasNothing() && phone.hasNothing());
        network.passSeconds(1);

        assertEquals(
                new SsReleaseComplete(asked.transaction(), Cause.RECOVERY_ON_TIMER_EXPIRY),
                robot.next(SsReleaseComplete.class));
        assertEquals(result("5550200 has not answered within 60 seconds."), end());
    }

    @Test
    void aRobotThatIsBusyOrVanishesIsReportedAsThat() {
        TestMobile robot = network.attach("5550200");
        ask("*200*5550200#");
        robot.answerPaging();
        TransactionIdentifier transaction =
                robot.next(SsRegister.class).transaction().answered();
        robot.tell(new SsReleaseComplete(
                transaction, ComponentCodec.encode(new Component.ReturnError(1, SsError.USSD_BUSY))));
        assertEquals(result("5550200 is busy with another service. Please try again."), end());
        robot.leaveReleasedChannel();

        ask("*200*5550200#");
        robot.answerPaging();
        robot.next(SsRegister.class);
        robot.vanish();
        assertEquals(result("5550200 is not registered or does not answer."), end());
    }

    @Test
    void twoPhonesThatAskOneRobotAtOnceAreBothAnswered() {
        TestMobile robot = network.attach("5550200");
        TestMobile other = network.attach("5550101");
        ask("*200*5550200#");
        other.requestService(MobilityManagement.ServiceType.SUPPLEMENTARY_SERVICE);
        other.tell(new SsRegister(
                OURS,
                invoke(SsOperation.PROCESS_UNSTRUCTURED_SS_REQUEST, "*200*5550200#"),
                Optional.of(SsRegister.PHASE_2)));

        robot.answerPaging();
        SsRegister asked = robot.next(SsRegister.class);
        robot.tell(
                new SsFacility(asked.transaction().answered(), reply(question(asked.facility(), "** #*0 **"), REPORT)));

        assertEquals(result(REPORT), end());
        assertEquals(
                result(REPORT),
                component(other.next(SsReleaseComplete.class).facility().orElseThrow()));
    }

    @Test
    void theMenuLeadsThroughQuestionsToAnAnswer() {
        String menu = "1 Own number\n2 Status of a robot\n0 End";
        ask("*111#");
        int first = question(phone.next(SsFacility.class).facility(), menu);
        phone.tell(new SsFacility(OURS, reply(first, "7")));
        int second = question(phone.next(SsFacility.class).facility(), "Please answer 1, 2 or 0.\n" + menu);
        phone.tell(new SsFacility(OURS, reply(second, "2")));
        int third = question(phone.next(SsFacility.class).facility(), "Number of the robot?");
        phone.tell(new SsFacility(OURS, reply(third, "x")));

        assertEquals(result("That is no telephone number."), end());
    }

    @Test
    void aMenuThatIsNotAnsweredEndsAfter60Seconds() {
        ask("*111#");
        phone.next(SsFacility.class);
        network.passSeconds(60);

        assertEquals(
                new SsReleaseComplete(OURS.answered(), Cause.RECOVERY_ON_TIMER_EXPIRY),
                phone.next(SsReleaseComplete.class));
        phone.leaveReleasedChannel();
    }

    @Test
    void aMobileThatEndsItsMenuGetsItsChannelReleased() {
        ask("*111#");
        phone.next(SsFacility.class);
        phone.tell(new SsReleaseComplete(OURS));

        phone.leaveReleasedChannel();
        ask("*100#");
        assertEquals(result("5550100"), end());
    }

    @Test
    void anUnknownCodeIsAnUnexpectedDataValue() {
        ask("*999#");

        assertEquals(new Component.ReturnError(1, SsError.UNEXPECTED_DATA_VALUE), end());
    }

    @ParameterizedTest
    @EnumSource(value = SsOperation.class, mode = EnumSource.Mode.EXCLUDE, names = "PROCESS_UNSTRUCTURED_SS_REQUEST")
    void everyOperationOnAnotherServiceIsRefusedAsNotSupported(SsOperation operation) {
        begin(ComponentCodec.encode(new Component.Invoke(1, operation, OctetString.ofHex("3003040192"))));

        assertEquals(new Component.ReturnError(1, SsError.FACILITY_NOT_SUPPORTED), end());
    }

    @Test
    void anOperationThatNoStandardHasIsRejected() {
        begin(ComponentCodec.encode(new Component.Invoke(9, 200, Component.NONE)));

        assertEquals(new Component.Reject(Optional.of(9), SsProblem.UNRECOGNIZED_OPERATION), end());
    }

    @Test
    void aBrokenComponentIsRejectedAndABrokenArgumentToo() {
        begin(OctetString.ofHex("a1ff"));
        assertEquals(new Component.Reject(Optional.empty(), SsProblem.BADLY_STRUCTURED_COMPONENT), end());

        begin(ComponentCodec.encode(
                new Component.Invoke(2, SsOperation.PROCESS_UNSTRUCTURED_SS_REQUEST, OctetString.ofHex("3000"))));
        assertEquals(new Component.Reject(Optional.of(2), SsProblem.MISTYPED_PARAMETER), end());
    }

    @Test
    void withoutAGrantedServiceNoDialogueBegins() {
        phone.requestService(MobilityManagement.ServiceType.SUPPLEMENTARY_SERVICE);
        phone.tell(new SsFacility(OURS, invoke(SsOperation.UNSTRUCTURED_SS_REQUEST, "?")));
        assertEquals(
                new SsReleaseComplete(OURS.answered(), Cause.INVALID_TRANSACTION_IDENTIFIER),
                phone.next(SsReleaseComplete.class));

        phone.tell(
                new SsRegister(OURS, invoke(SsOperation.PROCESS_UNSTRUCTURED_SS_REQUEST, "*111#"), Optional.empty()));
        phone.next(SsFacility.class);
        phone.tell(new SsRegister(
                new TransactionIdentifier(1, false),
                invoke(SsOperation.PROCESS_UNSTRUCTURED_SS_REQUEST, "*100#"),
                Optional.empty()));
        assertEquals(
                new SsReleaseComplete(new TransactionIdentifier(1, true), Cause.MESSAGE_NOT_COMPATIBLE_WITH_STATE),
                phone.next(SsReleaseComplete.class));
    }

    @Test
    void aCallAndADialogueShareTheChannel() {
        ActiveCall call = network.activeCall("5550101", "5550102");
        TestMobile caller = call.caller();
        caller.tell(new MobilityManagement.CmServiceRequest(
                MobilityManagement.ServiceType.SUPPLEMENTARY_SERVICE, MobilityManagement.NO_KEY, caller.identity()));
        caller.next(MobilityManagement.CmServiceAccept.class);
        caller.tell(
                new SsRegister(OURS, invoke(SsOperation.PROCESS_UNSTRUCTURED_SS_REQUEST, "*100#"), Optional.empty()));

        assertEquals(
                result("5550101"),
                component(caller.next(SsReleaseComplete.class).facility().orElseThrow()));
        assertTrue(caller.hasNothing(), "the call keeps the channel");
    }
}
