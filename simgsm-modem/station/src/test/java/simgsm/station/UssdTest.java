package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simgsm.station.Scene.SECOND;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.air.Cause;
import simgsm.air.MobilityManagement.CmServiceAccept;
import simgsm.air.MobilityManagement.CmServiceReject;
import simgsm.air.MobilityManagement.CmServiceRequest;
import simgsm.air.MobilityManagement.ServiceType;
import simgsm.air.RadioResource.PagingResponse;
import simgsm.air.RejectCause;
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
    private static final TransactionIdentifier NETWORKS = new TransactionIdentifier(3, false);

    private final Scene scene = Scene.registered();

    private static OctetString invoke(int id, SsOperation operation, String text) {
        return ComponentCodec.encode(
                new Component.Invoke(id, operation, UssdText.of(text).encode()));
    }

    private static OctetString question(int id, String text) {
        return invoke(id, SsOperation.UNSTRUCTURED_SS_REQUEST, text);
    }

    private static OctetString answer(String text) {
        return ComponentCodec.encode(new Component.ReturnResult(
                1,
                SsOperation.PROCESS_UNSTRUCTURED_SS_REQUEST,
                UssdText.of(text).encode()));
    }

    private static Component componentOf(OctetString facility) {
        try {
            return ComponentCodec.decode(facility);
        } catch (ComponentFault fault) {
            throw new AssertionError(fault);
        }
    }

    /** A request up to REGISTER. */
    private SsRegister request(String code) {
        assertTrue(scene.station.sendUssd(code));
        assertEquals(
                ServiceType.SUPPLEMENTARY_SERVICE,
                scene.expectFirst(CmServiceRequest.class).service());
        scene.down(new CmServiceAccept());
        return scene.expect(SsRegister.class);
    }

    private void end(OctetString facility) {
        scene.down(new SsReleaseComplete(OURS.answered(), facility));
        scene.releaseChannel();
        scene.expectNothing();
    }

    /** The network begins a dialogue, after paging. */
    private void register(OctetString facility) {
        scene.page(scene.identity.imsi());
        scene.expectFirst(PagingResponse.class);
        scene.down(new SsRegister(NETWORKS, facility, Optional.empty()));
    }

    private SsError refusal() {
        SsReleaseComplete refused = scene.expect(SsReleaseComplete.class);
        Component.ReturnError error =
                (Component.ReturnError) componentOf(refused.facility().orElseThrow());
        return SsError.ofCode(error.error()).orElseThrow();
    }

    @Test
    void aCodeIsSentAndItsAnswerShown() {
        SsRegister sent = request("*100#");
        assertEquals(OURS, sent.transaction());
        assertEquals(Optional.of(SsRegister.PHASE_2), sent.version());
        assertEquals(invoke(1, SsOperation.PROCESS_UNSTRUCTURED_SS_REQUEST, "*100#"), sent.facility());
        assertEquals(1, scene.lastSendSequence, "REGISTER follows CM SERVICE REQUEST in the same count");

        end(answer("5550100"));

        assertEquals(List.of("ussd: 5550100"), scene.reported.lines());
    }

    @Test
    void aMenuIsASessionOfQuestionsAndReplies() {
        request("*111#");
        scene.down(new SsFacility(OURS.answered(), question(7, "1 or 2?")));
        assertEquals(List.of("ussd? 1 or 2?"), scene.reported.lines());

        assertTrue(scene.station.sendUssd("2"));
        Component.ReturnResult reply = (Component.ReturnResult)
                componentOf(scene.expect(SsFacility.class).facility());
        assertEquals(7, reply.id());
        assertEquals(UssdText.of("2").encode(), reply.result());

        end(answer("two"));
        assertEquals(List.of("ussd? 1 or 2?", "ussd: two"), scene.reported.lines());
    }

    @Test
    void theNetworksQuestionIsAnsweredInItsOwnDialogue() {
        register(question(1, "Status?"));
        assertTrue(scene.station.isAskedByNetwork());
        assertTrue(scene.station.sendUssd("fine"));
        assertEquals(NETWORKS.answered(), scene.expect(SsFacility.class).transaction());

        scene.down(new SsReleaseComplete(NETWORKS));
        scene.releaseChannel();
        assertEquals(List.of("ussd? Status?", "ussd over: completed"), scene.reported.lines());
    }

    @Test
    void aNoticeOfTheNetworkIsShownAndConfirmed() {
        register(invoke(1, SsOperation.UNSTRUCTURED_SS_NOTIFY, "Welcome"));

        assertEquals(
                new Component.ReturnResult(1),
                componentOf(scene.expect(SsFacility.class).facility()));
        scene.down(new SsReleaseComplete(NETWORKS));
        assertEquals(List.of("ussd: Welcome", "ussd over: completed"), scene.reported.lines());
    }

    @Test
    void aSecondDialogueOfTheNetworkIsBusy() {
        request("*100#");
        scene.down(new SsRegister(NETWORKS, question(1, "Status?"), Optional.empty()));

        assertEquals(SsError.USSD_BUSY, refusal());
        assertEquals(List.of(), scene.reported.lines());
    }

    @Test
    void aSecondRequestOfTheUserIsRefusedWhileTheFirstIsUnderWay() {
        request("*100#");

        assertFalse(scene.station.sendUssd("*111#"));
        scene.expectNothing();
    }

    @Test
    void theNetworksErrorIsReported() {
        request("*999#");
        end(ComponentCodec.encode(new Component.ReturnError(1, SsError.UNEXPECTED_DATA_VALUE)));

        assertEquals(List.of("ussd over: refused by the network 36"), scene.reported.lines());
    }

    @Test
    void aSupplementaryServiceIsAskedForAsTheStandardHasIt() {
        Component.Invoke sent = (Component.Invoke) componentOf(request("*#21#").facility());
        assertTrue(sent.is(SsOperation.INTERROGATE_SS));
        end(ComponentCodec.encode(new Component.ReturnError(1, SsError.FACILITY_NOT_SUPPORTED)));

        assertEquals(List.of("ussd over: refused by the network 21"), scene.reported.lines());
    }

    @Test
    void withoutServiceARequestWaits5Seconds() {
        scene.linkDown();
        scene.reported.clear();
        assertTrue(scene.station.sendUssd("*100#"));
        scene.pass(5 * SECOND - 1);
        assertEquals(List.of(), scene.reported.lines());
        scene.pass(1);
        assertEquals(List.of("ussd over: no service"), scene.reported.lines());
    }

    @Test
    void aRefusedConnectionIsReported() {
        assertTrue(scene.station.sendUssd("*100#"));
        scene.expectFirst(CmServiceRequest.class);
        scene.down(new CmServiceReject(RejectCause.CONGESTION));

        assertEquals(List.of("ussd over: no service"), scene.reported.lines());
    }

    @Test
    void aNetworkThatDoesNotAnswerIsGivenUpAfter120Seconds() {
        request("*100#");
        scene.pass(120 * SECOND - 1);
        assertEquals(List.of(), scene.reported.lines());
        scene.pass(1);

        assertEquals(new SsReleaseComplete(OURS), scene.expect(SsReleaseComplete.class));
        assertEquals(List.of("ussd over: no answer from the network"), scene.reported.lines());
    }

    @Test
    void theUserEndsADialogueWithReleaseComplete() {
        request("*111#");
        scene.down(new SsFacility(OURS.answered(), question(1, "1 or 2?")));
        assertTrue(scene.station.endUssd());

        assertEquals(new SsReleaseComplete(OURS), scene.expect(SsReleaseComplete.class));
        assertFalse(scene.station.endUssd());
        assertEquals(List.of("ussd? 1 or 2?", "ussd over: cancelled"), scene.reported.lines());
    }

    @Test
    void aChannelReleasedInADialogueEndsItAndTheNextRequestWorks() {
        request("*100#");
        scene.releaseChannel();
        assertEquals(List.of("ussd over: no service"), scene.reported.lines());

        scene.reported.clear();
        SsRegister again = request("*100#");
        scene.down(new SsReleaseComplete(again.transaction().answered(), answer("5550100")));
        assertEquals(List.of("ussd: 5550100"), scene.reported.lines());
    }

    @Test
    void anOperationThatTheMobileDoesNotKnowIsRejected() {
        scene.page(scene.identity.imsi());
        scene.expectFirst(PagingResponse.class);
        scene.down(new SsRegister(
                NETWORKS, invoke(5, SsOperation.PROCESS_UNSTRUCTURED_SS_REQUEST, "x"), Optional.empty()));

        SsReleaseComplete refused = scene.expect(SsReleaseComplete.class);
        assertEquals(
                new Component.Reject(Optional.of(5), SsProblem.UNRECOGNIZED_OPERATION),
                componentOf(refused.facility().orElseThrow()));
    }

    @Test
    void aFacilityWithoutADialogueIsAnsweredWithCause81() {
        scene.page(scene.identity.imsi());
        scene.expectFirst(PagingResponse.class);
        scene.down(new SsFacility(NETWORKS, question(1, "?")));

        assertEquals(
                new SsReleaseComplete(NETWORKS.answered(), Cause.INVALID_TRANSACTION_IDENTIFIER),
                scene.expect(SsReleaseComplete.class));
    }

    @Test
    void anEmptyOrTooLongTextIsRefusedBeforeItIsSent() {
        assertThrows(IllegalArgumentException.class, () -> scene.station.sendUssd(""));
        assertThrows(IllegalArgumentException.class, () -> scene.station.sendUssd("1".repeat(183)));
        scene.expectNothing();
    }
}
