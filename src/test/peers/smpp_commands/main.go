// Sends each command of SMPP once well and once in error: smpp_commands gosmpp|fiorix PORT ID PASSWORD RECEIVER
//
// Prints "command status" for each response, the status in hexadecimal, and "end" once the session was unbound in order.
// Every response must come within 5 s, read by the library without an error.
package main

import (
	"errors"
	"fmt"
	"os"
	"time"

	"github.com/fiorix/go-smpp/v2/smpp"
	fiorixpdu "github.com/fiorix/go-smpp/v2/smpp/pdu"
	"github.com/fiorix/go-smpp/v2/smpp/pdu/pdufield"
	"github.com/fiorix/go-smpp/v2/smpp/pdu/pdutext"
	"github.com/fiorix/go-smpp/v2/smpp/pdu/pdutlv"
	"github.com/linxGnu/gosmpp"
	"github.com/linxGnu/gosmpp/data"
	"github.com/linxGnu/gosmpp/pdu"
)

const (
	source   = "111"
	patience = 5 * time.Second
)

var address, systemID, password, receiver string

func check(err error) {
	if err != nil {
		fmt.Println("failed:", err)
		os.Exit(1)
	}
}

func say(command string, status uint32) {
	fmt.Printf("%s 0x%02x\n", command, status)
}

func main() {
	address, systemID, password, receiver = "127.0.0.1:"+os.Args[2], os.Args[3], os.Args[4], os.Args[5]
	if os.Args[1] == "gosmpp" {
		withGosmpp()
	} else {
		withFiorix()
	}
	fmt.Println("end")
}

func bindGosmpp(secret string, responses chan pdu.PDU, ended chan gosmpp.State) (*gosmpp.Session, error) {
	return gosmpp.NewSession(
		gosmpp.TRXConnector(gosmpp.NonTLSDialer, gosmpp.Auth{SMSC: address, SystemID: systemID, Password: secret}),
		gosmpp.Settings{
			ReadTimeout:      2 * patience,
			OnPDU:            func(p pdu.PDU, _ bool) { responses <- p },
			OnReceivingError: func(err error) { check(err) },
			OnClosed:         func(state gosmpp.State) { ended <- state },
		}, -1)
}

func withGosmpp() {
	responses := make(chan pdu.PDU, 10)
	ended := make(chan gosmpp.State, 10)
	_, refused := bindGosmpp("wrong", responses, ended)
	var bindError gosmpp.BindError
	if !errors.As(refused, &bindError) {
		check(fmt.Errorf("bind with a wrong password: %v", refused))
	}
	say("bind", uint32(bindError.CommandStatus))
	session, err := bindGosmpp(password, responses, ended)
	check(err)
	say("bind", 0)
	ask := func(command string, request pdu.PDU) pdu.PDU {
		check(session.Transceiver().Submit(request))
		select {
		case response := <-responses:
			say(command, uint32(response.GetHeader().CommandStatus))
			return response
		case <-time.After(patience):
			check(errors.New("no response to " + command))
			return nil
		}
	}
	at := func(value string) pdu.Address {
		found, err := pdu.NewAddressWithTonNpiAddr(1, 1, value)
		check(err)
		return found
	}
	for _, to := range []string{receiver, "letters"} {
		submit := pdu.NewSubmitSM().(*pdu.SubmitSM)
		submit.SourceAddr, submit.DestAddr = at(source), at(to)
		check(submit.Message.SetMessageWithEncoding("submit", data.GSM7BIT))
		id := ""
		if response, ok := ask("submit_sm", submit).(*pdu.SubmitSMResp); ok {
			id = response.MessageID
		}
		datum := pdu.NewDataSM().(*pdu.DataSM)
		datum.SourceAddr, datum.DestAddr = at(source), at(to)
		datum.RegisterOptionalParam(pdu.Field{Tag: pdu.TagMessagePayload, Data: []byte("data")})
		ask("data_sm", datum)
		multi := pdu.NewSubmitMulti().(*pdu.SubmitMulti)
		multi.SourceAddr = at(source)
		each := pdu.NewDestinationAddress()
		each.SetAddress(at(to))
		multi.DestAddrs.Add(each)
		check(multi.Message.SetMessageWithEncoding("multi", data.GSM7BIT))
		ask("submit_multi", multi)
		if id == "" {
			id = "999999"
		}
		query := pdu.NewQuerySM().(*pdu.QuerySM)
		query.MessageID, query.SourceAddr = id, at(source)
		ask("query_sm", query)
		replace := pdu.NewReplaceSM().(*pdu.ReplaceSM)
		replace.MessageID, replace.SourceAddr = id, at(source)
		check(replace.Message.SetMessageWithEncoding("replaced", data.GSM7BIT))
		ask("replace_sm", replace)
		cancel := pdu.NewCancelSM().(*pdu.CancelSM)
		cancel.MessageID, cancel.SourceAddr, cancel.DestAddr = id, at(source), at(to)
		ask("cancel_sm", cancel)
	}
	ask("enquire_link", pdu.NewEnquireLink())
	check(session.Close())
	if state := <-ended; state != gosmpp.ExplicitClosing {
		check(fmt.Errorf("closed: %s", &state))
	}
}

func statusOf(err error) uint32 {
	var status fiorixpdu.Status
	if err != nil && !errors.As(err, &status) {
		check(err)
	}
	return uint32(status)
}

func bindFiorix(secret string) (*smpp.Transceiver, smpp.ConnStatus) {
	session := &smpp.Transceiver{
		Addr: address, User: systemID, Passwd: secret, RespTimeout: patience, EnquireLink: patience, BindInterval: patience,
	}
	return session, <-session.Bind()
}

func withFiorix() {
	refused, status := bindFiorix("wrong")
	say("bind", statusOf(status.Error()))
	refused.Close()
	session, status := bindFiorix(password)
	say("bind", statusOf(status.Error()))
	for _, to := range []string{receiver, "letters"} {
		message := func(text string) *smpp.ShortMessage {
			return &smpp.ShortMessage{
				Src: source, Dst: to, SourceAddrTON: 1, SourceAddrNPI: 1, DestAddrTON: 1, DestAddrNPI: 1,
				Text: pdutext.Raw(text), Register: pdufield.NoDeliveryReceipt,
			}
		}
		submitted, err := session.Submit(message("submit"))
		say("submit_sm", statusOf(err))
		id := "999999"
		if err == nil {
			id = submitted.RespID()
		}
		data := message("data")
		data.TLVFields = pdutlv.Fields{pdutlv.TagMessagePayload: []byte("data")}
		_, err = session.SubmitData(data)
		say("data_sm", statusOf(err))
		multi := message("multi")
		multi.Dst, multi.DstList = "", []string{to}
		_, err = session.Submit(multi)
		say("submit_multi", statusOf(err))
		_, err = session.QuerySM(source, id, 1, 1)
		say("query_sm", statusOf(err))
		say("replace_sm", statusOf(session.ReplaceSM(message("replaced"), id)))
		say("cancel_sm", statusOf(session.CancelSM(message(""), id)))
	}
	say("enquire_link", 0) // The library tests its link by itself, and reports only a failure.
	check(session.Close())
}
