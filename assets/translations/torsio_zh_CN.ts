<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>AboutBox</name>
    <message>
        <source>Training and assessment of surgical twist skills.</source>
        <translation>外科扭转技能的培训与评估。</translation>
    </message>
    <message>
        <source>This is a training tool and not a medical device. It holds no patient data and must not be used to decide about a patient.</source>
        <translation>本软件是培训工具，不是医疗器械。它不保存患者数据，不得用于对患者作出决定。</translation>
    </message>
    <message>
        <source>Built with Qt %1 for %2, running on %3.</source>
        <translation>使用 Qt %1 构建（%2），运行于 %3。</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later, without any warranty.</source>
        <translation>自由软件，采用 GNU 通用公共许可证第 3 版或更高版本，不提供任何担保。</translation>
    </message>
    <message>
        <source>About Torsio</source>
        <translation>关于 Torsio</translation>
    </message>
</context>
<context>
    <name>Administration</name>
    <message>
        <source>no cohort yet</source>
        <translation>尚无批次</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 等，另有 %2 项</translation>
    </message>
</context>
<context>
    <name>AlertPanel</name>
    <message>
        <source>recordings cut off: %1</source>
        <translation>录制中断：%1</translation>
    </message>
    <message>
        <source>stations that do not answer: %1</source>
        <translation>没有应答的工作站：%1</translation>
    </message>
    <message>
        <source>devices not fit: %1</source>
        <translation>设备不合格：%1</translation>
    </message>
    <message>
        <source>uneven runs: %1</source>
        <translation>力反馈不稳的操作：%1</translation>
    </message>
    <message>
        <source>overdue: %1</source>
        <translation>逾期：%1</translation>
    </message>
    <message>
        <source>rests too long: %1</source>
        <translation>休息过长：%1</translation>
    </message>
    <message>
        <source>sheets missing: %1</source>
        <translation>缺少评分表：%1</translation>
    </message>
    <message>
        <source>without a group: %1</source>
        <translation>未分组：%1</translation>
    </message>
    <message>
        <source>What needs attention</source>
        <translation>需要注意的事项</translation>
    </message>
</context>
<context>
    <name>CopiesText</name>
    <message>
        <source>These copies still hold this person; Torsio deletes none of them:</source>
        <translation>以下副本仍包含此人的资料；Torsio 不会删除它们：</translation>
    </message>
    <message>
        <source>%1 at %2: %3, to be deleted by %4</source>
        <translation>%1，位于 %2：%3，应于 %4 前删除</translation>
    </message>
    <message>
        <source>and %1 older ones; torsio db copies lists all</source>
        <translation>另有 %1 个更早的副本；用 torsio db copies 可列出全部</translation>
    </message>
</context>
<context>
    <name>CurriculumState</name>
    <message>
        <source>%1: changed, not saved. The draft is also saved when you leave.</source>
        <translation>%1：已更改，未保存。离开时草稿也会保存。</translation>
    </message>
    <message>
        <source>Everything may be changed; nobody is touched until it is published as version %1.</source>
        <translation>一切均可更改；在发布为第 %1 版之前不影响任何人。</translation>
    </message>
    <message>
        <source>Saved %1. %2</source>
        <translation>已于 %1 保存。%2</translation>
    </message>
    <message>
        <source>%1 The newest version is %2: %3.</source>
        <translation>%1 最新版本为第 %2 版：%3。</translation>
    </message>
    <message>
        <source>No cohort follows it.</source>
        <translation>没有批次采用。</translation>
    </message>
    <message>
        <source>Followed by: %1.</source>
        <translation>采用的批次：%1。</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>Published on %1 and never changes. Begin it, so that cohorts can follow it.</source>
        <translation>已于 %1 发布，不再改变。启用后批次才能采用。</translation>
    </message>
    <message>
        <source>Published on %1, running: cohorts can choose it. It never changes; to change anything, edit the draft and publish the next version.</source>
        <translation>已于 %1 发布，进行中：批次可以选用。它不再改变；如需更改，请编辑草稿并发布下一版。</translation>
    </message>
    <message>
        <source>Published on %1, closed: no further cohort can choose it; who follows it goes on. It is kept as it was.</source>
        <translation>已于 %1 发布，已关闭：不再有新批次可选用；已采用的继续进行。内容保持原样。</translation>
    </message>
    <message>
        <source>%1 Note: %2.</source>
        <translation>%1 说明：%2。</translation>
    </message>
    <message>
        <source>%1 Superseded by version %2.</source>
        <translation>%1 已被第 %2 版取代。</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
</context>
<context>
    <name>Desk</name>
    <message>
        <source>Training</source>
        <translation>培训</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>评阅</translation>
    </message>
    <message>
        <source>Administration</source>
        <translation>管理</translation>
    </message>
</context>
<context>
    <name>GroupMoveDialog</name>
    <message>
        <source>Move to another group</source>
        <translation>调整到其他组</translation>
    </message>
    <message>
        <source>%1 was put into a group by the draw. A move by hand stands beside the drawn record for good, with its reason, and weakens the study.</source>
        <translation>%1 由随机抽取分入某组。手动调整及其原因将与抽取记录一并永久保存，并会削弱研究的可信度。</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>组别(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Reason</source>
        <translation>原因(&amp;R)</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>调整</translation>
    </message>
</context>
<context>
    <name>InvitationQuestion</name>
    <message>
        <source>Invite</source>
        <translation>邀请登录</translation>
    </message>
    <message>
        <source>%1: a link each, with which they set a password of their own in a browser. A link made before is of no use then.</source>
        <translation>%1：每人一个链接，可在浏览器中设置自己的密码。之前生成的链接随即失效。</translation>
    </message>
    <message>
        <source>&amp;Address of the review desk</source>
        <translation>评分台地址(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Reason</source>
        <translation>原因(&amp;R)</translation>
    </message>
    <message>
        <source>This needs two people: you get a code for each to hand over, and another administrator, who confirms it, the link.</source>
        <translation>此操作需要两人：您得到每人的代码并转交，另一位管理员确认后得到链接。</translation>
    </message>
    <message>
        <source>As torsio serve says it when it starts, or as your proxy is called.</source>
        <translation>即 torsio serve 启动时显示的地址，或您的代理服务器的地址。</translation>
    </message>
    <message>
        <source>&amp;Invite</source>
        <translation>邀请(&amp;I)</translation>
    </message>
</context>
<context>
    <name>MailServerDialog</name>
    <message>
        <source>Mail server</source>
        <translation>邮件服务器</translation>
    </message>
    <message>
        <source>Reminders go through this server of your centre. Its password is kept nowhere: whoever sends enters it.</source>
        <translation>提醒通过贵中心的这台服务器发送。密码不保存在任何地方：由发送者输入。</translation>
    </message>
    <message>
        <source>STARTTLS (port 587)</source>
        <translation>STARTTLS（端口 587）</translation>
    </message>
    <message>
        <source>TLS from the beginning (port 465)</source>
        <translation>全程 TLS（端口 465）</translation>
    </message>
    <message>
        <source>none: a server on this computer</source>
        <translation>无：本机上的服务器</translation>
    </message>
    <message>
        <source>&amp;Server</source>
        <translation>服务器(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Encryption</source>
        <translation>加密(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>端口(&amp;P)</translation>
    </message>
    <message>
        <source>Sign-in &amp;name, if it asks for one</source>
        <translation>登录名(&amp;N)，如果需要</translation>
    </message>
    <message>
        <source>Messages come &amp;from</source>
        <translation>发件地址(&amp;F)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
</context>
<context>
    <name>Pages</name>
    <message>
        <source>My next step</source>
        <translation>我的下一步</translation>
    </message>
    <message>
        <source>Debrief</source>
        <translation>训练复盘</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>趋势</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>评语</translation>
    </message>
    <message>
        <source>Transcript</source>
        <translation>成绩单</translation>
    </message>
    <message>
        <source>Device check</source>
        <translation>设备检查</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>知情同意</translation>
    </message>
    <message>
        <source>Briefing</source>
        <translation>任务说明</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Free practice</source>
        <translation>自由练习</translation>
    </message>
    <message>
        <source>Compare models</source>
        <translation>模型对比</translation>
    </message>
    <message>
        <source>Queue</source>
        <translation>待评列表</translation>
    </message>
    <message>
        <source>Rater calibration</source>
        <translation>评分校准</translation>
    </message>
    <message>
        <source>Live sheet</source>
        <translation>现场评分表</translation>
    </message>
    <message>
        <source>Discrepancy review</source>
        <translation>评分分歧复核</translation>
    </message>
    <message>
        <source>My severity</source>
        <translation>我的严格度</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>模型评价</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>案例</translation>
    </message>
    <message>
        <source>Roster</source>
        <translation>人员名册</translation>
    </message>
    <message>
        <source>Curricula</source>
        <translation>课程</translation>
    </message>
    <message>
        <source>Cohorts</source>
        <translation>批次</translation>
    </message>
    <message>
        <source>Allocation</source>
        <translation>随机分组</translation>
    </message>
    <message>
        <source>Scoring</source>
        <translation>评分</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Reports</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Users</source>
        <translation>用户</translation>
    </message>
    <message>
        <source>Audit trail</source>
        <translation>审计记录</translation>
    </message>
    <message>
        <source>Maintenance</source>
        <translation>维护</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>迁移</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Today&apos;s sessions</source>
        <translation>今日训练</translation>
    </message>
    <message>
        <source>Heads of the audit trail</source>
        <translation>审计记录的链头</translation>
    </message>
</context>
<context>
    <name>PersonDialog</name>
    <message>
        <source>Change a person</source>
        <translation>修改人员</translation>
    </message>
    <message>
        <source>New person</source>
        <translation>新建人员</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>female</source>
        <translation>女</translation>
    </message>
    <message>
        <source>male</source>
        <translation>男</translation>
    </message>
    <message>
        <source>other</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右手</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左手</translation>
    </message>
    <message>
        <source>does not score</source>
        <translation>不评分</translation>
    </message>
    <message>
        <source>&amp;Trains</source>
        <translation>参加培训(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Full name</source>
        <translation>姓名(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Number</source>
        <translation>编号(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;E-mail</source>
        <translation>电子邮箱(&amp;E)</translation>
    </message>
    <message>
        <source>Se&amp;x</source>
        <translation>性别(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Level</source>
        <translation>级别(&amp;L)</translation>
    </message>
    <message>
        <source>Ex&amp;perience</source>
        <translation>经验(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Age</source>
        <translation>年龄(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Handedness</source>
        <translation>惯用手(&amp;H)</translation>
    </message>
    <message>
        <source>S&amp;cores as</source>
        <translation>评分身份(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Reason of the change</source>
        <translation>修改原因(&amp;R)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Add person</source>
        <translation>添加人员</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Enter the full name.</source>
        <translation>请输入姓名。</translation>
    </message>
    <message>
        <source>Choose a class here, or tick that the person trains.</source>
        <translation>请在此选择类别，或勾选此人参加训练。</translation>
    </message>
</context>
<context>
    <name>PointerKeys</name>
    <message>
        <source>Move left</source>
        <translation>向左移动</translation>
    </message>
    <message>
        <source>Move right</source>
        <translation>向右移动</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>向上移动</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>向下移动</translation>
    </message>
    <message>
        <source>Move deeper</source>
        <translation>向深处移动</translation>
    </message>
    <message>
        <source>Move nearer</source>
        <translation>向近处移动</translation>
    </message>
    <message>
        <source>Twist anticlockwise</source>
        <translation>逆时针扭转</translation>
    </message>
    <message>
        <source>Twist clockwise</source>
        <translation>顺时针扭转</translation>
    </message>
    <message>
        <source>Tilt left</source>
        <translation>向左倾斜</translation>
    </message>
    <message>
        <source>Tilt right</source>
        <translation>向右倾斜</translation>
    </message>
    <message>
        <source>Tilt up</source>
        <translation>向上倾斜</translation>
    </message>
    <message>
        <source>Tilt down</source>
        <translation>向下倾斜</translation>
    </message>
    <message>
        <source>Grip while held</source>
        <translation>按住时夹持</translation>
    </message>
    <message>
        <source>Keep the grip</source>
        <translation>保持夹持</translation>
    </message>
    <message>
        <source>Set a bookmark</source>
        <translation>设置书签</translation>
    </message>
    <message>
        <source>Keys of the instrument</source>
        <translation>器械按键</translation>
    </message>
    <message>
        <source>That key moves something else already.</source>
        <translation>该按键已用于其他动作。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Usual keys</source>
        <translation>默认按键</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
</context>
<context>
    <name>PrintedCards</name>
    <message>
        <source>No. %1. Open when the training begins.</source>
        <translation>第 %1 号。训练开始时拆开。</translation>
    </message>
    <message>
        <source>%1 trains in group</source>
        <translation>%1 所在小组</translation>
    </message>
    <message>
        <source>Sealed cards: %1</source>
        <translation>密封卡片：%1</translation>
    </message>
    <message>
        <source>Your way into Torsio. For you alone.</source>
        <translation>您的 Torsio 登录信息。仅供本人使用。</translation>
    </message>
    <message>
        <source>Sign-in name: %1</source>
        <translation>登录名：%1</translation>
    </message>
    <message>
        <source>Choose your own password at the first sign-in.</source>
        <translation>首次登录时请设置自己的密码。</translation>
    </message>
    <message>
        <source>Start passwords: %1</source>
        <translation>初始密码：%1</translation>
    </message>
    <message>
        <source>%1. Your way into Torsio. For you alone.</source>
        <translation>%1。Torsio 登录信息，仅供本人使用。</translation>
    </message>
    <message>
        <source>%1: hold the card to the scanner, or type the code</source>
        <translation>%1：请将卡片对准扫码器，或输入代码</translation>
    </message>
    <message>
        <source>Cards for the kiosk: %1</source>
        <translation>自助终端卡片：%1</translation>
    </message>
    <message>
        <source>Open this address in a browser, once, and choose a password</source>
        <translation>在浏览器中打开此地址（仅一次），并设置密码</translation>
    </message>
    <message>
        <source>For you alone. Your sign-in name: %1</source>
        <translation>仅供您本人使用。您的登录名：%1</translation>
    </message>
    <message>
        <source>The code that goes with your link</source>
        <translation>与您的链接配套的代码</translation>
    </message>
    <message>
        <source>The link comes by another way.</source>
        <translation>链接通过其他途径送达。</translation>
    </message>
    <message>
        <source>Invitations: %1</source>
        <translation>登录邀请：%1</translation>
    </message>
</context>
<context>
    <name>PrintedConsent</name>
    <message>
        <source>I agree</source>
        <translation>我同意</translation>
    </message>
    <message>
        <source>I do not agree</source>
        <translation>我不同意</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>知情同意</translation>
    </message>
    <message>
        <source>%1. Code: %2</source>
        <translation>%1。编码：%2</translation>
    </message>
    <message>
        <source>Mark one box in each row. Nothing is recorded before you agree to the training record; the other answers are free. You can withdraw each of them later at any time.</source>
        <translation>每行请勾选一个方框。在您同意训练记录之前不会记录任何内容；其余各项可自由选择。每一项同意以后都可随时撤回。</translation>
    </message>
    <message>
        <source>Name: ________________________________________</source>
        <translation>姓名：________________________________________</translation>
    </message>
    <message>
        <source>Date: ________________   Signature: ______________________________</source>
        <translation>日期：________________   签名：______________________________</translation>
    </message>
    <message>
        <source>Text %1. Entered by ______________ on ______________</source>
        <translation>文本 %1。录入人 ______________ 录入日期 ______________</translation>
    </message>
</context>
<context>
    <name>PrintedSheets</name>
    <message>
        <source>or exactly: ______</source>
        <translation>或精确分数：______</translation>
    </message>
    <message>
        <source>cannot be assessed, because: ____________________</source>
        <translation>无法评分，原因：____________________</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>Sheet: case %1, rater %2</source>
        <translation>评分表：案例 %1，评分者 %2</translation>
    </message>
    <message>
        <source>%1. Mark one box in each row. Do not write any name on this sheet.</source>
        <translation>%1。每行勾选一格。请勿在本表上写任何姓名。</translation>
    </message>
    <message>
        <source>Overall mark</source>
        <translation>总分</translation>
    </message>
    <message>
        <source>Comment: ______________________________________________________________</source>
        <translation>评语：______________________________________________________________</translation>
    </message>
    <message>
        <source>Date, time: __________________   Signature: ______________________________</source>
        <translation>日期、时间：__________________   签名：______________________________</translation>
    </message>
    <message>
        <source>Revision %1 of the scoring sheet. Typed in by (1) ______________ and (2) ______________, independently of each other.</source>
        <translation>评分表第 %1 版。由 (1) ______________ 和 (2) ______________ 各自独立录入。</translation>
    </message>
    <message>
        <source>Call list: %1</source>
        <translation>呼叫名单：%1</translation>
    </message>
    <message>
        <source>Room: %1. For the office only: raters are told the case, not this list.</source>
        <translation>房间：%1。仅供办公室使用：评分者只知道案例编号，看不到本名单。</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>序号</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>学员</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>组别</translation>
    </message>
    <message>
        <source>Now at</source>
        <translation>当前阶段</translation>
    </message>
    <message>
        <source>Scoring due</source>
        <translation>待评分时点</translation>
    </message>
    <message>
        <source>Sheets missing</source>
        <translation>缺评分表</translation>
    </message>
    <message>
        <source>Called at</source>
        <translation>呼叫时间</translation>
    </message>
    <message>
        <source>Left at</source>
        <translation>离开时间</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Sheets on paper</source>
        <translation>纸质评分表</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>可进行</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>是(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>否(&amp;N)</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>重试</translation>
    </message>
</context>
<context>
    <name>QWidgetTextControl</name>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>剪切(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>粘贴(&amp;P)</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>全选</translation>
    </message>
</context>
<context>
    <name>ReasonDialog</name>
    <message>
        <source>&amp;Reason</source>
        <translation>原因(&amp;R)</translation>
    </message>
    <message>
        <source>Say why: the reason stays in the record.</source>
        <translation>请说明原因：原因会保留在记录中。</translation>
    </message>
</context>
<context>
    <name>Reassignment</name>
    <message>
        <source>Reassign sheets</source>
        <translation>改派评分表</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message numerus="yes">
        <source>The sheets of %n row(s) of the matrix.</source>
        <translation>
            <numerusform>评分矩阵中 %n 行的评分表。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: taken back %2</source>
        <translation>%1：已收回 %2</translation>
    </message>
    <message>
        <source>%1: open or begun %2</source>
        <translation>%1：未填或已开始 %2</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>从(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>给(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Reason</source>
        <translation>原因(&amp;R)</translation>
    </message>
    <message>
        <source>Reassign</source>
        <translation>改派</translation>
    </message>
    <message>
        <source>%1 again</source>
        <translation>仍交给 %1</translation>
    </message>
    <message>
        <source>nobody: take them back only</source>
        <translation>无人：仅收回</translation>
    </message>
    <message>
        <source>None of these sheets is open or was taken back.</source>
        <translation>这些评分表中没有未填或已收回的。</translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s) change hands.</source>
        <translation>
            <numerusform>将转交 %n 份评分表。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stay(s): the other rater is asked about these cases already.</source>
        <translation>
            <numerusform>保留 %n 份：另一位评分者已被邀请评这些案例。</numerusform>
        </translation>
    </message>
    <message>
        <source>Asked about all these cases already: choose somebody else.</source>
        <translation>该评分者已受邀评这些案例：请另选他人。</translation>
    </message>
</context>
<context>
    <name>ReminderText</name>
    <message>
        <source>case %1 (late; called %2)</source>
        <translation>案例 %1（逾期；%2 呼叫）</translation>
    </message>
    <message>
        <source>case %1 (called %2)</source>
        <translation>案例 %1（%2 呼叫）</translation>
    </message>
    <message>
        <source>case %1</source>
        <translation>案例 %1</translation>
    </message>
    <message>
        <source>case %1 (late; was due %2)</source>
        <translation>案例 %1（逾期；应于 %2 前完成）</translation>
    </message>
    <message>
        <source>case %1 (due %2)</source>
        <translation>案例 %1（%2 前完成）</translation>
    </message>
    <message>
        <source>%1: please submit in Torsio: %2</source>
        <translation>%1：请在 Torsio 中提交：%2</translation>
    </message>
    <message>
        <source>Nobody owes a sheet.</source>
        <translation>没有人欠交评分表。</translation>
    </message>
    <message numerus="yes">
        <source>Copied: the sheets that %n rater(s) owe</source>
        <translation>
            <numerusform>已复制：%n 名评分者欠交的评分表</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RetentionDialog</name>
    <message>
        <source>trainee</source>
        <translation>学员</translation>
    </message>
    <message>
        <source>rater</source>
        <translation>评分者</translation>
    </message>
    <message>
        <source>left the centre</source>
        <translation>已离开中心</translation>
    </message>
    <message>
        <source>consent withdrawn</source>
        <translation>已撤回同意</translation>
    </message>
    <message>
        <source> days</source>
        <translation> 天</translation>
    </message>
    <message>
        <source>Days: %1</source>
        <translation>天数：%1</translation>
    </message>
    <message>
        <source>lawful basis</source>
        <translation>法律依据</translation>
    </message>
    <message>
        <source>Lawful basis: %1</source>
        <translation>法律依据：%1</translation>
    </message>
    <message>
        <source>Rules for keeping records</source>
        <translation>记录保存规则</translation>
    </message>
    <message>
        <source>After this long without activity a record is listed for review. Nothing is erased by itself.</source>
        <translation>超过此期限无活动的记录将列入审查。任何内容都不会自动删除。</translation>
    </message>
    <message>
        <source>Save these rules</source>
        <translation>保存这些规则</translation>
    </message>
</context>
<context>
    <name>RosterTexts</name>
    <message>
        <source>+ new</source>
        <translation>+ 新增</translation>
    </message>
    <message>
        <source>= as it is</source>
        <translation>= 不变</translation>
    </message>
    <message>
        <source>→ changes</source>
        <translation>→ 有更改</translation>
    </message>
    <message>
        <source>! error</source>
        <translation>! 错误</translation>
    </message>
    <message>
        <source>%1. %2.</source>
        <translation>%1。%2。</translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <translation>%1：%2 → %3</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
</context>
<context>
    <name>RunDay</name>
    <message>
        <source>Trainee</source>
        <translation>学员</translation>
    </message>
    <message>
        <source>on the simulator</source>
        <translation>在模拟器上</translation>
    </message>
    <message>
        <source>on the real arm</source>
        <translation>在实物手臂上</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>休息</translation>
    </message>
    <message>
        <source>came late</source>
        <translation>迟到</translation>
    </message>
    <message>
        <source>did not come</source>
        <translation>缺席</translation>
    </message>
    <message>
        <source>device failed</source>
        <translation>设备故障</translation>
    </message>
    <message>
        <source>swapped with somebody</source>
        <translation>与他人互换</translation>
    </message>
    <message>
        <source>phase cut short</source>
        <translation>阶段提前结束</translation>
    </message>
    <message>
        <source>phase too long</source>
        <translation>阶段超时</translation>
    </message>
    <message>
        <source>rest too long</source>
        <translation>休息超时</translation>
    </message>
    <message>
        <source>something else</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>Log time</source>
        <translation>登记时间</translation>
    </message>
    <message>
        <source> min</source>
        <translation> 分钟</translation>
    </message>
    <message>
        <source>&amp;What</source>
        <translation>内容(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;How long</source>
        <translation>时长(&amp;H)</translation>
    </message>
    <message>
        <source>Report a deviation</source>
        <translation>报告方案偏离</translation>
    </message>
    <message>
        <source>What happened, without names</source>
        <translation>发生了什么（勿写姓名）</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>类型(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;What happened</source>
        <translation>经过(&amp;W)</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Swap turns</source>
        <translation>互换顺序</translation>
    </message>
    <message>
        <source>Why, without names</source>
        <translation>原因（不写姓名）</translation>
    </message>
    <message>
        <source>&amp;With</source>
        <translation>与(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Reason</source>
        <translation>原因(&amp;R)</translation>
    </message>
    <message>
        <source>Their groups stay as drawn; a deviation is noted for both and appears in the report.</source>
        <translation>双方分组不变；两人均记录方案偏离并列入报告。</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>互换</translation>
    </message>
    <message>
        <source>trained before scoring</source>
        <translation>评分前已训练</translation>
    </message>
</context>
<context>
    <name>Scoring</name>
    <message>
        <source>Rater</source>
        <translation>评分者</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>类别</translation>
    </message>
    <message>
        <source>Ask</source>
        <translation>邀请</translation>
    </message>
    <message>
        <source>&amp;Reason</source>
        <translation>原因(&amp;R)</translation>
    </message>
    <message>
        <source>Release marks</source>
        <translation>公布评分</translation>
    </message>
    <message>
        <source>Trainees see their marks of an occasion from the release on.</source>
        <translation>公布后学员可看到该评分时点的评分。</translation>
    </message>
    <message>
        <source>%1: released, take back</source>
        <translation>%1：已公布，收回</translation>
    </message>
    <message>
        <source>Occa&amp;sion</source>
        <translation>评分时点(&amp;S)</translation>
    </message>
    <message>
        <source>Do it</source>
        <translation>执行</translation>
    </message>
    <message>
        <source>%1, live</source>
        <translation>%1，现场</translation>
    </message>
    <message>
        <source>Assign an adjudicator</source>
        <translation>指派仲裁评分者</translation>
    </message>
    <message>
        <source>Physicians could not agree about these cases and ask for one more. The freest one of the same class is suggested; nobody learns who asked.</source>
        <translation>医师对这些案例意见不一，请求再加一位。已建议同级别中任务最少者；被指派者不会知道由谁提出。</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>学员</translation>
    </message>
    <message>
        <source>Occasion</source>
        <translation>评分时点</translation>
    </message>
    <message>
        <source>Asked by</source>
        <translation>提出者</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>创建时间</translation>
    </message>
    <message>
        <source>Cases that need an adjudicator</source>
        <translation>需要仲裁评分者的案例</translation>
    </message>
    <message>
        <source>&amp;Rater</source>
        <translation>评分者(&amp;R)</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>指派</translation>
    </message>
    <message>
        <source>To be done by the end of</source>
        <translation>须于此日结束前完成</translation>
    </message>
    <message>
        <source>Deadline</source>
        <translation>截止日期</translation>
    </message>
    <message>
        <source>Invite raters</source>
        <translation>邀请评分者</translation>
    </message>
    <message>
        <source>%1: release, sheets missing: %2 of %3</source>
        <translation>%1：公布，缺 %2 / %3 份</translation>
    </message>
    <message>
        <source>%1, %2: sheets waiting: %3</source>
        <translation>%1，%2：待评 %3 份</translation>
    </message>
    <message>
        <source>for each case the freest of the same class</source>
        <translation>每个案例交给同类别中任务最少者</translation>
    </message>
    <message>
        <source>Case labels tell neither name, group nor occasion. Recordings come in an order of their own for each rater, the real arm as you call.</source>
        <translation>案例标签不透露姓名、组别或评分时点。每位评分者的录制顺序各不相同；实物手臂按您的叫号进行。</translation>
    </message>
</context>
<context>
    <name>SecondPerson</name>
    <message>
        <source>This is the first half of the start password of %1. Hand it over; the second half comes from the administrator who confirms. It is shown only now.</source>
        <translation>这是 %1 的初始密码的前半部分，请转交本人；后半部分由确认的管理员给出。仅此时显示。</translation>
    </message>
    <message>
        <source>This is the second half of the start password of %1, behind the first one and a hyphen. Hand it over; the first half comes from whoever asked. It is shown only now.</source>
        <translation>这是 %1 的初始密码的后半部分，接在前半部分和一个连字符之后。请转交本人；前半部分由申请人给出。仅此时显示。</translation>
    </message>
    <message>
        <source>Hand this start password to %1. It is shown only now, and must be changed at the first sign-in.</source>
        <translation>请将此初始密码交给 %1。密码只在此时显示，首次登录时必须修改。</translation>
    </message>
    <message>
        <source>Start password</source>
        <translation>初始密码</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>已复制</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Two people</source>
        <translation>两人共同完成</translation>
    </message>
    <message>
        <source>This needs two people: you ask for it, and another administrator confirms it. Ask for it now?</source>
        <translation>此事需要两人：由您提出申请，由另一位管理员确认。现在提出申请吗？</translation>
    </message>
    <message>
        <source>&amp;Ask</source>
        <translation>申请(&amp;A)</translation>
    </message>
    <message>
        <source>Asked. Another administrator confirms it under Users, Requests</source>
        <translation>已提出申请。另一位管理员将在“用户”的“申请”中确认</translation>
    </message>
</context>
<context>
    <name>SignDialog</name>
    <message>
        <source>Sign</source>
        <translation>签名</translation>
    </message>
    <message>
        <source>Your &amp;password</source>
        <translation>您的密码(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Sign</source>
        <translation>签名(&amp;S)</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>“%1”</translation>
    </message>
    <message>
        <source>You sign this as %1. Your name, the time and this meaning are kept with it for good.</source>
        <translation>您以 %1 的身份签名。您的姓名、签名时间和这一含义将随之永久保存。</translation>
    </message>
</context>
<context>
    <name>StationLabels</name>
    <message>
        <source>%1 min</source>
        <translation>%1 分钟</translation>
    </message>
    <message>
        <source>a moment</source>
        <translation>片刻</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 小时</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>已锁定</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>可进行</translation>
    </message>
    <message>
        <source>Mastered</source>
        <translation>已掌握</translation>
    </message>
    <message>
        <source>No attempt left</source>
        <translation>尝试次数已用完</translation>
    </message>
    <message>
        <source>First master: %1</source>
        <translation>请先掌握：%1</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between titles</comment>
        <translation>、</translation>
    </message>
    <message>
        <source>Ask an administrator for another attempt.</source>
        <translation>请向管理员申请追加尝试。</translation>
    </message>
    <message>
        <source>%1: none</source>
        <translation>%1：无</translation>
    </message>
    <message>
        <source>%1: at most %2</source>
        <translation>%1：不超过 %2</translation>
    </message>
    <message>
        <source>%1: at least %2</source>
        <translation>%1：不低于 %2</translation>
    </message>
    <message>
        <source>Not tried yet</source>
        <translation>尚未尝试</translation>
    </message>
    <message>
        <source>Unlocks: %1</source>
        <translation>解锁：%1</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>未测得</translation>
    </message>
    <message>
        <source>Learning</source>
        <translation>学习中</translation>
    </message>
    <message>
        <source>Steady</source>
        <translation>稳定</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>需关注</translation>
    </message>
    <message>
        <source>Relapsed</source>
        <translation>退步</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>已连接</translation>
    </message>
    <message>
        <source>Stylus docked</source>
        <translation>手柄已归位</translation>
    </message>
    <message>
        <source>Calibrated</source>
        <translation>已校准</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Update rate</source>
        <translation>刷新率</translation>
    </message>
    <message>
        <source>Hand and seat</source>
        <translation>手与坐姿</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Practice only</source>
        <translation>仅可练习</translation>
    </message>
    <message>
        <source>Not ready</source>
        <translation>未就绪</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>not undone, ischaemic dose %1</source>
        <translation>未复位，缺血剂量 %1</translation>
    </message>
    <message>
        <source>undone, blood after %1, ischaemic dose %2</source>
        <translation>已复位，%1 后恢复血流，缺血剂量 %2</translation>
    </message>
    <message>
        <source>undone, ischaemic dose %1</source>
        <translation>已复位，缺血剂量 %1</translation>
    </message>
    <message>
        <source>Last time: %1</source>
        <translation>上次：%1</translation>
    </message>
    <message>
        <source>blood did not come back</source>
        <translation>血流未恢复</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>无定义</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>quantity and value</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Measured before by version %1 of the definitions: peak force %2, within the limits. That is kept and no longer counts.</source>
        <translation>此前按第 %1 版定义测得：最大力 %2，未超限值。该结果予以保留，但不再作数。</translation>
    </message>
    <message>
        <source>Measured before by version %1 of the definitions: peak force %2, beyond the limits. That is kept and no longer counts.</source>
        <translation>此前按第 %1 版定义测得：最大力 %2，超出限值。该结果予以保留，但不再作数。</translation>
    </message>
    <message>
        <source>So few attempts can show nobody to be able.</source>
        <translation>尝试这么少，无法表明任何人已胜任。</translation>
    </message>
    <message>
        <source>Able, and staying so.</source>
        <translation>已胜任，并保持稳定。</translation>
    </message>
    <message>
        <source>Able before; the last attempts raise a doubt.</source>
        <translation>此前已胜任；最近几次尝试令人存疑。</translation>
    </message>
    <message>
        <source>Able before, not now. Practise until the level is steady again.</source>
        <translation>此前已胜任，现在不再是。请练习到水平重新稳定。</translation>
    </message>
    <message numerus="yes">
        <source>%n day(s)</source>
        <translation>
            <numerusform>%n 天</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, in %n run(s) in a row</source>
        <translation>
            <numerusform>%1，连续 %n 次操作</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, in %n run(s) in a row (%2 so far)</source>
        <translation>
            <numerusform>%1，连续 %n 次操作（目前 %2 次）</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Last time: %1 of %n twist(s) on target</source>
        <translation>
            <numerusform>上次：%n 次扭转中 %1 次达标</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more attempt(s) until a level is shown</source>
        <translation>
            <numerusform>再尝试 %n 次即显示水平</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Not yet shown to be able. %n good attempt(s) in a row show it.</source>
        <translation>
            <numerusform>尚未表明已胜任。连续 %n 次成功即可表明。</numerusform>
        </translation>
    </message>
    <message>
        <source>Last time: interrupted after %1</source>
        <translation>上次：%1 后中断</translation>
    </message>
    <message>
        <source>Level: %1. %2</source>
        <translation>水平：%1。%2</translation>
    </message>
</context>
<context>
    <name>Study</name>
    <message>
        <source>before training</source>
        <translation>训练前</translation>
    </message>
    <message>
        <source>half-way</source>
        <translation>训练中</translation>
    </message>
    <message>
        <source>after training</source>
        <translation>训练后</translation>
    </message>
    <message>
        <source>enrolled</source>
        <translation>已登记</translation>
    </message>
    <message>
        <source>completed</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>withdrew</source>
        <translation>已退出</translation>
    </message>
    <message>
        <source>sex</source>
        <translation>性别</translation>
    </message>
    <message>
        <source>level of education</source>
        <translation>学历</translation>
    </message>
    <message>
        <source>experience</source>
        <translation>经验</translation>
    </message>
    <message>
        <source>handedness</source>
        <translation>惯用手</translation>
    </message>
    <message>
        <source>female</source>
        <translation>女</translation>
    </message>
    <message>
        <source>male</source>
        <translation>男</translation>
    </message>
    <message>
        <source>other</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>left-handed</source>
        <translation>左利手</translation>
    </message>
    <message>
        <source>right-handed</source>
        <translation>右利手</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>intern</source>
        <translation>实习医师</translation>
    </message>
    <message>
        <source>deputy chief physician</source>
        <translation>副主任医师</translation>
    </message>
    <message>
        <source>chief physician</source>
        <translation>主任医师</translation>
    </message>
    <message>
        <source>Shuffled blocks, one after another</source>
        <translation>依次随机区组</translation>
    </message>
    <message>
        <source>Shuffled blocks within strata</source>
        <translation>分层随机区组</translation>
    </message>
    <message>
        <source>Minimisation (Pocock and Simon)</source>
        <translation>最小化法（Pocock 与 Simon）</translation>
    </message>
    <message>
        <source>open</source>
        <translation>未开始</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>草稿</translation>
    </message>
    <message>
        <source>submitted</source>
        <translation>已提交</translation>
    </message>
    <message>
        <source>taken back</source>
        <translation>已收回</translation>
    </message>
    <message>
        <source>published, not begun</source>
        <translation>已发布，未启用</translation>
    </message>
    <message>
        <source>running</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>已关闭</translation>
    </message>
    <message>
        <source>simulator</source>
        <translation>模拟器</translation>
    </message>
    <message>
        <source>real arm</source>
        <translation>实物手臂</translation>
    </message>
    <message>
        <source>share of twists on target</source>
        <translation>达标扭转比例</translation>
    </message>
    <message>
        <source>targets reached</source>
        <translation>达到目标次数</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>overshoot</source>
        <translation>超调</translation>
    </message>
    <message>
        <source>settling time</source>
        <translation>稳定时间</translation>
    </message>
    <message>
        <source>steadiness of the hold</source>
        <translation>保持稳定性</translation>
    </message>
    <message>
        <source>smoothness</source>
        <translation>平滑度</translation>
    </message>
    <message>
        <source>peak force</source>
        <translation>最大力</translation>
    </message>
    <message>
        <source>force violations</source>
        <translation>力超限次数</translation>
    </message>
    <message>
        <source>peak torque</source>
        <translation>最大扭矩</translation>
    </message>
    <message>
        <source>organ undone (1 yes, 0 no)</source>
        <translation>器官已复位（1 是，0 否）</translation>
    </message>
    <message>
        <source>time until blood flows</source>
        <translation>恢复血流的时间</translation>
    </message>
    <message>
        <source>ischaemic dose</source>
        <translation>缺血剂量</translation>
    </message>
    <message>
        <source>twist that remains</source>
        <translation>残余扭转</translation>
    </message>
    <message>
        <source>relapse (1 yes, 0 no)</source>
        <translation>复发（1 是，0 否）</translation>
    </message>
    <message>
        <source>first turn the right way (1 yes, 0 no)</source>
        <translation>首次转动方向正确（1 是，0 否）</translation>
    </message>
    <message>
        <source>turned the wrong way</source>
        <translation>反向转动</translation>
    </message>
    <message>
        <source>re-grips</source>
        <translation>重新夹持次数</translation>
    </message>
    <message>
        <source>slipped back</source>
        <translation>回滑</translation>
    </message>
    <message>
        <source>peak pressure of the jaw</source>
        <translation>钳口压强峰值</translation>
    </message>
    <message>
        <source>time of overload</source>
        <translation>超负荷时间</translation>
    </message>
    <message>
        <source>let out first (1 yes, 0 no)</source>
        <translation>先行减压（1 是，0 否）</translation>
    </message>
    <message>
        <source>longest turn without a rest</source>
        <translation>未停歇的最大复位转角</translation>
    </message>
    <message>
        <source>undone in stages (1 yes, 0 no)</source>
        <translation>分阶段复位（1 是，0 否）</translation>
    </message>
    <message>
        <source>Simple randomisation into equal groups (as in the paper)</source>
        <translation>简单随机化，各组人数相等（与论文相同）</translation>
    </message>
</context>
<context>
    <name>TableChoice</name>
    <message>
        <source>Table 1,234.5 with commas (*.csv)</source>
        <translation>逗号分隔表格，1,234.5 (*.csv)</translation>
    </message>
    <message>
        <source>Table 1234,5 with semicolons, for Excel in German, French ... (*.csv)</source>
        <translation>分号分隔表格，1234,5，适用于德语、法语等 Excel (*.csv)</translation>
    </message>
    <message>
        <source>Table with tabulators (*.tsv)</source>
        <translation>制表符分隔表格 (*.tsv)</translation>
    </message>
</context>
<context>
    <name>Text</name>
    <message>
        <source>Choose another name</source>
        <translation>请另选名称</translation>
    </message>
    <message>
        <source>Effectiveness</source>
        <translation>有效性</translation>
    </message>
    <message>
        <source>Force feedback</source>
        <translation>力反馈</translation>
    </message>
    <message>
        <source>Give every occasion another code</source>
        <translation>请为每个评分时点指定不同的代码</translation>
    </message>
    <message>
        <source>Occasion of scoring added</source>
        <translation>已添加评分时点</translation>
    </message>
    <message>
        <source>Real-time performance</source>
        <translation>实时性</translation>
    </message>
    <message>
        <source>Rule for keeping records taken away</source>
        <translation>已取消记录保存规则</translation>
    </message>
    <message>
        <source>System stability</source>
        <translation>系统稳定性</translation>
    </message>
    <message>
        <source>Deformation efficiency</source>
        <translation>变形效率</translation>
    </message>
    <message>
        <source>Fidelity</source>
        <translation>逼真度</translation>
    </message>
    <message>
        <source>Image fluency</source>
        <translation>画面流畅度</translation>
    </message>
    <message>
        <source>Telepresence</source>
        <translation>临场感</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>纹理质感</translation>
    </message>
    <message>
        <source>an occasion has no code of its own</source>
        <translation>某个评分时点没有自己的代码</translation>
    </message>
    <message>
        <source>another occasion has this name</source>
        <translation>另一评分时点已使用此名称</translation>
    </message>
    <message>
        <source>interns</source>
        <translation>实习医师</translation>
    </message>
    <message>
        <source>deputy chief physicians</source>
        <translation>副主任医师</translation>
    </message>
    <message>
        <source>chief physicians</source>
        <translation>主任医师</translation>
    </message>
    <message>
        <source>deputy chief physician</source>
        <translation>副主任医师</translation>
    </message>
    <message>
        <source>chief physician</source>
        <translation>主任医师</translation>
    </message>
    <message>
        <source>intern</source>
        <translation>实习医师</translation>
    </message>
    <message>
        <source>This cannot be done like this</source>
        <translation>无法这样操作</translation>
    </message>
    <message>
        <source>A file or folder is missing</source>
        <translation>缺少文件或文件夹</translation>
    </message>
    <message>
        <source>A file cannot be read</source>
        <translation>文件无法读取</translation>
    </message>
    <message>
        <source>A file cannot be written</source>
        <translation>文件无法写入</translation>
    </message>
    <message>
        <source>The shape of the organ cannot be used</source>
        <translation>器官的形状无法使用</translation>
    </message>
    <message>
        <source>A value is not allowed here</source>
        <translation>此处不允许该数值</translation>
    </message>
    <message>
        <source>The data do not fit together</source>
        <translation>数据不一致</translation>
    </message>
    <message>
        <source>The database refused the operation</source>
        <translation>数据库拒绝了该操作</translation>
    </message>
    <message>
        <source>The database was written by a newer version</source>
        <translation>数据库由更新的版本写入</translation>
    </message>
    <message>
        <source>Your role may not do this</source>
        <translation>您的角色没有此权限</translation>
    </message>
    <message>
        <source>The haptic device has a problem</source>
        <translation>力反馈设备出现问题</translation>
    </message>
    <message>
        <source>A check found a difference</source>
        <translation>校验发现差异</translation>
    </message>
    <message>
        <source>The organ would be folded</source>
        <translation>器官会发生折叠</translation>
    </message>
    <message>
        <source>Something unexpected happened</source>
        <translation>发生意外情况</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1。%2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is chosen for two fields</source>
        <translation>“%1”被选给了两个字段</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no likely age in years</source>
        <translation>“%1”不像是年龄（岁）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not understood as %2</source>
        <translation>“%1”无法识别为%2</translation>
    </message>
    <message>
        <source>&quot;other&quot; needs a description</source>
        <translation>选择“其他”时需要说明</translation>
    </message>
    <message>
        <source>%1 % of the ticks came within 0.1 ms of their time, %2 late, %3 after a pause of more than 5 ms (the force is cut then)</source>
        <translation>%1 % 的周期与预定时间相差不到 0.1 ms，迟到 %2 个，停顿超过 5 ms 后到达 %3 个（此时切断力输出）</translation>
    </message>
    <message>
        <source>%1 %2 asked for; the lattice takes %3 to %4</source>
        <translation>要求的%2为 %1；网格线可用 %3 至 %4</translation>
    </message>
    <message>
        <source>%1 %2 asked for; the lattice takes %3 to %4 (%5)</source>
        <translation>要求的%2为 %1；网格线可用 %3 至 %4（%5）</translation>
    </message>
    <message>
        <source>%1 %2 is not a whole number from %3 to %4</source>
        <translation>%1 %2 不是 %3 至 %4 之间的整数</translation>
    </message>
    <message>
        <source>%1 N upwards were sent without complaint; only the hand can tell whether they were felt</source>
        <translation>已向上输出 %1 N，设备无异常报告；是否有感觉只有手能判断</translation>
    </message>
    <message>
        <source>%1 after %2 s</source>
        <translation>%2 秒后：%1</translation>
    </message>
    <message>
        <source>%1 end</source>
        <translation>%1端</translation>
    </message>
    <message>
        <source>%1 has a decimal comma</source>
        <translation>%1 使用了逗号作小数点</translation>
    </message>
    <message>
        <source>%1 has no mark yet</source>
        <translation>“%1”尚未评分</translation>
    </message>
    <message>
        <source>%1 is not a finite number</source>
        <translation>%1 不是有限的数</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 不是数字</translation>
    </message>
    <message>
        <source>%1 is stored already with other content; what is stored stays</source>
        <translation>%1 已以不同内容存储；已存储的内容保持不变</translation>
    </message>
    <message>
        <source>%1 is too large or too small</source>
        <translation>%1 过大或过小</translation>
    </message>
    <message>
        <source>%1 lacks %2</source>
        <translation>%1 缺少 %2</translation>
    </message>
    <message>
        <source>%1 must lie above 0 s and not above %2 s, got %3</source>
        <translation>%1必须大于 0 秒且不超过 %2 秒，实际为 %3</translation>
    </message>
    <message>
        <source>%1 people still wait for a group: the seed would tell them theirs</source>
        <translation>还有 %1 人等待分组：公布种子会泄露其组别</translation>
    </message>
    <message>
        <source>%1, got %2</source>
        <translation>%1，实际为 %2</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1，第 %2 行</translation>
    </message>
    <message>
        <source>%1, mastery %2</source>
        <translation>%1，掌握标准 %2</translation>
    </message>
    <message>
        <source>%1, phase %2</source>
        <translation>%1，第 %2 阶段</translation>
    </message>
    <message>
        <source>%1, serial number %2, driver %3, library %4, opened as %5</source>
        <translation>%1，序列号 %2，驱动 %3，程序库 %4，打开方式 %5</translation>
    </message>
    <message>
        <source>%1; 1000 Hz are wanted</source>
        <translation>%1；应为 1000 Hz</translation>
    </message>
    <message>
        <source>%1; below %2 Hz no force is rendered</source>
        <translation>%1；低于 %2 Hz 时不输出力</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not known</source>
        <translation>“%1”无法识别</translation>
    </message>
    <message>
        <source>20 min virtual, 20 min real arm</source>
        <translation>虚拟 20 分钟，实物手臂 20 分钟</translation>
    </message>
    <message>
        <source>40 min real arm</source>
        <translation>实物手臂 40 分钟</translation>
    </message>
    <message>
        <source>40 min virtual</source>
        <translation>虚拟 40 分钟</translation>
    </message>
    <message>
        <source>A saved recording cannot be read and stays where it is: %1</source>
        <translation>一份已保存的录制无法读取，文件保留原处：%1</translation>
    </message>
    <message>
        <source>A saved recording was not stored, because %1. Its file is kept: %2</source>
        <translation>一份已保存的录制未能入库，原因：%1。文件已保留：%2</translation>
    </message>
    <message>
        <source>Add --organ-unit %1</source>
        <translation>请加上 --organ-unit %1</translation>
    </message>
    <message>
        <source>Add a module, or begin with a template</source>
        <translation>请添加模块，或从模板开始</translation>
    </message>
    <message>
        <source>Add a new version instead</source>
        <translation>请改为添加新版本</translation>
    </message>
    <message>
        <source>Add a rubric first</source>
        <translation>请先添加评分标准</translation>
    </message>
    <message>
        <source>Add at least one</source>
        <translation>请至少添加一个</translation>
    </message>
    <message>
        <source>Add at least one criterion</source>
        <translation>请至少添加一条评分项</translation>
    </message>
    <message>
        <source>Add it</source>
        <translation>请添加</translation>
    </message>
    <message>
        <source>Add it.</source>
        <translation>请添加</translation>
    </message>
    <message>
        <source>Add one line a person</source>
        <translation>请每人填写一行</translation>
    </message>
    <message>
        <source>Add one row a value</source>
        <translation>请每个数值填写一行</translation>
    </message>
    <message>
        <source>Allocate them first, or give a reason</source>
        <translation>请先为其分组，或说明理由</translation>
    </message>
    <message>
        <source>Allow more attempts, or ask for fewer</source>
        <translation>请增加允许次数，或降低要求</translation>
    </message>
    <message>
        <source>Angles are not known better than that on this device; have it serviced</source>
        <translation>该设备的角度精度仅能如此；请送修</translation>
    </message>
    <message>
        <source>Ask about a practice run</source>
        <translation>请就练习操作提问</translation>
    </message>
    <message>
        <source>Ask an administrator to add you to the roster</source>
        <translation>请联系管理员将您加入名册</translation>
    </message>
    <message>
        <source>Ask an administrator, or sign in as somebody who may</source>
        <translation>请联系管理员，或使用有权限的账号登录</translation>
    </message>
    <message>
        <source>Ask an administrator</source>
        <translation>请联系管理员</translation>
    </message>
    <message>
        <source>Ask an administrator for another attempt</source>
        <translation>请向管理员申请追加尝试</translation>
    </message>
    <message>
        <source>Ask an administrator what comes next</source>
        <translation>请向管理员询问后续安排</translation>
    </message>
    <message>
        <source>Begin with a line that names the columns</source>
        <translation>请在首行写明各列名称</translation>
    </message>
    <message>
        <source>Begin with the header %1</source>
        <translation>请以标题行 %1 开头</translation>
    </message>
    <message>
        <source>Brisk, no idle moment</source>
        <translation>利落，没有空闲</translation>
    </message>
    <message>
        <source>Calibrate again in the inkwell; on another model this is to be expected</source>
        <translation>请在笔座中重新校准；其他型号出现此差异属正常</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>校准</translation>
    </message>
    <message>
        <source>Care for the tissue</source>
        <translation>组织保护</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>Check both machines, then copy again</source>
        <translation>请检查两台计算机，然后重新复制</translation>
    </message>
    <message>
        <source>Check cable and power, plug the device in again and start anew</source>
        <translation>请检查电缆和电源，重新插拔设备后再开始</translation>
    </message>
    <message>
        <source>Check cable and power, then plug the device in again and repeat the check</source>
        <translation>请检查电缆和电源，重新插拔设备后再次检查</translation>
    </message>
    <message>
        <source>Check power and cable, run the vendor&apos;s set-up tool once as this user, and check the rights on the device file (docs/devices.md)</source>
        <translation>请检查电源和电缆，以当前用户运行一次厂商的设置工具，并检查设备文件的权限（docs/devices.md）</translation>
    </message>
    <message>
        <source>Check that it is a file you may read</source>
        <translation>请确认它是您有权读取的文件</translation>
    </message>
    <message>
        <source>Check that it runs and that the address is right</source>
        <translation>请确认服务器正在运行且地址正确</translation>
    </message>
    <message>
        <source>Check that it runs, and that address, user and password are right</source>
        <translation>请确认服务器正在运行，且地址、用户名和密码正确</translation>
    </message>
    <message>
        <source>Check that the folder exists, is not read-only, and that the disk is not full</source>
        <translation>请确认文件夹存在、可写入且磁盘未满</translation>
    </message>
    <message>
        <source>Check that the mesh is one closed surface without handles.</source>
        <translation>请确认网格是一个无环柄的封闭曲面</translation>
    </message>
    <message>
        <source>Check that the mesh is one connected surface and that its ends do not touch.</source>
        <translation>请确认网格是一个连通曲面且两端不相接</translation>
    </message>
    <message>
        <source>Check that you may read and write in its folder</source>
        <translation>请确认您可以读写其所在文件夹</translation>
    </message>
    <message>
        <source>Check the assets folder.</source>
        <translation>请检查资源文件夹</translation>
    </message>
    <message>
        <source>Check the code</source>
        <translation>请检查代码</translation>
    </message>
    <message>
        <source>Check the database, and restore a backup</source>
        <translation>请检查数据库并恢复备份</translation>
    </message>
    <message>
        <source>Check the database.</source>
        <translation>请检查数据库</translation>
    </message>
    <message>
        <source>Check the device&apos;s power supply and repeat the check</source>
        <translation>请检查设备电源后再次检查</translation>
    </message>
    <message>
        <source>Check the disk, and the database itself</source>
        <translation>请检查磁盘及数据库本身</translation>
    </message>
    <message>
        <source>Check the folder and the free space</source>
        <translation>请检查文件夹和剩余空间</translation>
    </message>
    <message>
        <source>Check the id and the database</source>
        <translation>请检查编号和数据库</translation>
    </message>
    <message>
        <source>Check the limits that the device reports</source>
        <translation>请检查设备报告的限值</translation>
    </message>
    <message>
        <source>Check the path</source>
        <translation>请检查路径</translation>
    </message>
    <message>
        <source>Check the task and the profile</source>
        <translation>请检查任务和参数</translation>
    </message>
    <message>
        <source>Check the unit, or move the mesh near the origin</source>
        <translation>请检查单位，或将网格移到原点附近</translation>
    </message>
    <message>
        <source>Check what it refers to</source>
        <translation>请检查其引用的内容</translation>
    </message>
    <message>
        <source>Checking recording %1 of %2</source>
        <translation>正在检查第 %1 条录制，共 %2 条</translation>
    </message>
    <message>
        <source>Choose a folder in which you may write</source>
        <translation>请选择您可以写入的文件夹</translation>
    </message>
    <message>
        <source>Choose a folder in which you may write, or open the database for reading only</source>
        <translation>请选择您可以写入的文件夹，或以只读方式打开数据库</translation>
    </message>
    <message>
        <source>Choose a later day</source>
        <translation>请选择更晚的日期</translation>
    </message>
    <message>
        <source>Choose a mark between the ends of the scale</source>
        <translation>请在量表两端之间选择评分</translation>
    </message>
    <message>
        <source>Choose a metric from the list</source>
        <translation>请从列表中选择指标</translation>
    </message>
    <message>
        <source>Choose a phase of the trainee&apos;s own arm</source>
        <translation>请选择该学员所在组别的阶段</translation>
    </message>
    <message>
        <source>Choose a time within it</source>
        <translation>请选择其范围内的时刻</translation>
    </message>
    <message>
        <source>Choose active or left</source>
        <translation>请选择“在册”或“已离开”</translation>
    </message>
    <message>
        <source>Choose an existing one</source>
        <translation>请选择已有的一项</translation>
    </message>
    <message>
        <source>Choose an older backup</source>
        <translation>请选择更早的备份</translation>
    </message>
    <message>
        <source>Choose an open module</source>
        <translation>请选择可进行的模块</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>请选择其他文件</translation>
    </message>
    <message>
        <source>Choose another file, or restore the latest backup</source>
        <translation>请选择其他文件，或恢复最近的备份</translation>
    </message>
    <message>
        <source>Choose another group</source>
        <translation>请选择其他组别</translation>
    </message>
    <message>
        <source>Choose another name; frozen data stay as they are</source>
        <translation>请换一个名称；已冻结的数据保持不变</translation>
    </message>
    <message>
        <source>Choose another one</source>
        <translation>请选择另一个</translation>
    </message>
    <message>
        <source>Choose another recording</source>
        <translation>请选择其他录制</translation>
    </message>
    <message>
        <source>Choose another recording: a case must be blinded</source>
        <translation>请选择其他录制：案例必须盲评</translation>
    </message>
    <message>
        <source>Choose another trainee</source>
        <translation>请选择其他学员</translation>
    </message>
    <message>
        <source>Choose at least one</source>
        <translation>请至少选择一项</translation>
    </message>
    <message>
        <source>Choose at least one of the two</source>
        <translation>请至少选择其中一项</translation>
    </message>
    <message>
        <source>Choose at least one trainee</source>
        <translation>请至少选择一名学员</translation>
    </message>
    <message>
        <source>Choose at least or at most</source>
        <translation>请选择“不低于”或“不超过”</translation>
    </message>
    <message>
        <source>Choose female, male, other or nothing</source>
        <translation>请选择女、男、其他或留空</translation>
    </message>
    <message>
        <source>Choose from the list</source>
        <translation>请从列表中选择</translation>
    </message>
    <message>
        <source>Choose left, right or nothing</source>
        <translation>请选择左、右或留空</translation>
    </message>
    <message>
        <source>Choose one</source>
        <translation>请选择一项</translation>
    </message>
    <message>
        <source>Choose one column a field</source>
        <translation>请为每个字段选择一列</translation>
    </message>
    <message>
        <source>Choose one from the list</source>
        <translation>请从列表中选择一项</translation>
    </message>
    <message>
        <source>Choose one from the list, or none for any module</source>
        <translation>请从列表中选择一项；留空表示任意模块</translation>
    </message>
    <message>
        <source>Choose one of %1.</source>
        <translation>请选择其中之一：%1</translation>
    </message>
    <message>
        <source>Choose one of the cohort</source>
        <translation>请选择该批次中的一位</translation>
    </message>
    <message>
        <source>Choose one of the file</source>
        <translation>请选择文件中的一项</translation>
    </message>
    <message>
        <source>Choose one of the list</source>
        <translation>请从列表中选择一项</translation>
    </message>
    <message>
        <source>Choose one of the two</source>
        <translation>请选择其中之一</translation>
    </message>
    <message>
        <source>Choose prerequisites from the list</source>
        <translation>请从列表中选择先修模块</translation>
    </message>
    <message>
        <source>Choose prerequisites from the same version</source>
        <translation>请从同一版本中选择先修模块</translation>
    </message>
    <message>
        <source>Choose raters of this class, or take its weight away</source>
        <translation>请选择该类评分者，或取消其权重</translation>
    </message>
    <message>
        <source>Choose sex, level, experience or handedness</source>
        <translation>请选择性别、学历、经验或惯用手</translation>
    </message>
    <message>
        <source>Choose somebody else</source>
        <translation>请选择其他人</translation>
    </message>
    <message>
        <source>Choose the backup again</source>
        <translation>请重新选择备份</translation>
    </message>
    <message>
        <source>Close Torsio at every station and try again</source>
        <translation>请关闭所有工作站上的 Torsio 后重试</translation>
    </message>
    <message>
        <source>Close and repair the mesh.</source>
        <translation>请封闭并修复网格</translation>
    </message>
    <message>
        <source>Close every other program that uses the device, then try again</source>
        <translation>请关闭所有使用该设备的其他程序后重试</translation>
    </message>
    <message>
        <source>Close every other program that uses the device; restart Torsio</source>
        <translation>请关闭所有使用该设备的其他程序，并重新启动 Torsio</translation>
    </message>
    <message>
        <source>Close every other program that uses the device; restart the computer</source>
        <translation>请关闭所有使用该设备的其他程序，并重新启动计算机</translation>
    </message>
    <message>
        <source>Close other programs and try again</source>
        <translation>请关闭其他程序后重试</translation>
    </message>
    <message>
        <source>Close other programs that use it</source>
        <translation>请关闭使用它的其他程序</translation>
    </message>
    <message>
        <source>Close other programs; on Linux allow real-time scheduling for this user (docs/devices.md)</source>
        <translation>请关闭其他程序；在 Linux 上请为该用户启用实时调度（docs/devices.md）</translation>
    </message>
    <message>
        <source>Close the holes in a mesh editor</source>
        <translation>请在网格编辑器中封闭孔洞</translation>
    </message>
    <message>
        <source>Close the quoted value</source>
        <translation>请补上右引号</translation>
    </message>
    <message>
        <source>Close the tunnels: an organ&apos;s outer surface has none</source>
        <translation>请封闭贯通孔：器官外表面没有贯通孔</translation>
    </message>
    <message>
        <source>Come back when they are</source>
        <translation>请待其提交后再来</translation>
    </message>
    <message>
        <source>Comparing %1</source>
        <translation>正在比较 %1</translation>
    </message>
    <message>
        <source>Comparing with the record</source>
        <translation>正在与记录比较</translation>
    </message>
    <message>
        <source>Connect the haptic device for a graded run</source>
        <translation>计分操作请连接力反馈设备</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Copy the record of this station there</source>
        <translation>请将本工作站的记录复制到那里</translation>
    </message>
    <message>
        <source>Copying %1</source>
        <translation>正在复制 %1</translation>
    </message>
    <message>
        <source>Correct the curriculum</source>
        <translation>请修正课程</translation>
    </message>
    <message>
        <source>Correct the file, or remove it</source>
        <translation>请修正或移除该文件</translation>
    </message>
    <message>
        <source>Correct the file.</source>
        <translation>请修正文件</translation>
    </message>
    <message>
        <source>Correct the mark</source>
        <translation>请更正评分</translation>
    </message>
    <message>
        <source>Correct the migration file</source>
        <translation>请修正迁移文件</translation>
    </message>
    <message>
        <source>Correct the number</source>
        <translation>请更正数值</translation>
    </message>
    <message>
        <source>Correct the person&apos;s record, or lock a new design with a reason</source>
        <translation>请更正此人的记录，或说明理由后锁定新方案</translation>
    </message>
    <message>
        <source>Correct the text</source>
        <translation>请更正文本</translation>
    </message>
    <message>
        <source>Correct the value</source>
        <translation>请更正数值</translation>
    </message>
    <message>
        <source>Correct the value.</source>
        <translation>请更正数值</translation>
    </message>
    <message>
        <source>Create it, or choose another</source>
        <translation>请创建，或选择其他位置</translation>
    </message>
    <message>
        <source>DISPLAY and WAYLAND_DISPLAY are not set</source>
        <translation>未设置 DISPLAY 和 WAYLAND_DISPLAY</translation>
    </message>
    <message>
        <source>Decimate the surface</source>
        <translation>请简化曲面</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Do not score it; tell an administrator</source>
        <translation>请勿评分，并告知管理员</translation>
    </message>
    <message>
        <source>Does not finish; long stops</source>
        <translation>未完成；停顿长</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Draft becomes running, running becomes closed</source>
        <translation>草稿之后为进行中，进行中之后为已关闭</translation>
    </message>
    <message>
        <source>Draw the group first</source>
        <translation>请先抽取组别</translation>
    </message>
    <message>
        <source>End the value at the closing quote</source>
        <translation>请在右引号处结束该值</translation>
    </message>
    <message>
        <source>Enrol trainees first</source>
        <translation>请先登记学员</translation>
    </message>
    <message>
        <source>Enter 1 to 36500</source>
        <translation>请输入 1 至 36500</translation>
    </message>
    <message>
        <source>Enter a limit above 0 N m, or none</source>
        <translation>请输入大于 0 N m 的限值，或不设限</translation>
    </message>
    <message>
        <source>Enter a limit above 0 N, or none</source>
        <translation>请输入大于 0 N 的限值，或不设限</translation>
    </message>
    <message>
        <source>Enter at least one degree</source>
        <translation>请输入至少 1 度</translation>
    </message>
    <message>
        <source>Enter how far to twist</source>
        <translation>请输入扭转角度</translation>
    </message>
    <message>
        <source>Enter its minutes</source>
        <translation>请输入分钟数</translation>
    </message>
    <message>
        <source>Enter one</source>
        <translation>请输入一个</translation>
    </message>
    <message>
        <source>Enter the age in years, or leave it empty</source>
        <translation>请输入年龄（岁），或留空</translation>
    </message>
    <message>
        <source>Enter the full name</source>
        <translation>请输入全名</translation>
    </message>
    <message>
        <source>Enter the minutes</source>
        <translation>请输入分钟数</translation>
    </message>
    <message>
        <source>Enter the name of your centre</source>
        <translation>请输入中心名称</translation>
    </message>
    <message>
        <source>Enter the trainee first</source>
        <translation>请先录入该学员</translation>
    </message>
    <message>
        <source>Export the mesh again</source>
        <translation>请重新导出网格</translation>
    </message>
    <message>
        <source>Export the mesh again.</source>
        <translation>请重新导出网格</translation>
    </message>
    <message>
        <source>Far from the angle, slips</source>
        <translation>离目标角度远，打滑</translation>
    </message>
    <message>
        <source>Fill both in</source>
        <translation>请填写这两项</translation>
    </message>
    <message>
        <source>Fill in the cell</source>
        <translation>请填写该单元格</translation>
    </message>
    <message>
        <source>Fill it in</source>
        <translation>请填写</translation>
    </message>
    <message>
        <source>Fill it in and submit it</source>
        <translation>请填写并提交</translation>
    </message>
    <message>
        <source>Fill it in or remove the line</source>
        <translation>请填写，或删除该行</translation>
    </message>
    <message>
        <source>Finish or move what uses them first; nothing was removed</source>
        <translation>请先结束或移走正在使用它的内容；未删除任何内容</translation>
    </message>
    <message>
        <source>Finishes with some waiting</source>
        <translation>完成，有些等待</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>入门</translation>
    </message>
    <message>
        <source>Fluent, one movement</source>
        <translation>流畅，一气呵成</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Forearm: graded, with little force</source>
        <translation>前臂：计分，轻柔用力</translation>
    </message>
    <message>
        <source>Forearm: pronate to 60 degrees</source>
        <translation>前臂：旋前 60 度</translation>
    </message>
    <message>
        <source>Free some space in the temporary folder</source>
        <translation>请清理临时文件夹的空间</translation>
    </message>
    <message>
        <source>Free some space on the disk</source>
        <translation>请清理磁盘空间</translation>
    </message>
    <message>
        <source>Free some space on this disk</source>
        <translation>请清理此磁盘的空间</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>几何</translation>
    </message>
    <message>
        <source>Give 0 for the default or a positive length.</source>
        <translation>请填 0 使用默认值，或填正的长度</translation>
    </message>
    <message>
        <source>Give 60 for twenty seconds a phase</source>
        <translation>填 60 时每个阶段为二十秒</translation>
    </message>
    <message>
        <source>Give a closed surface that encloses the organ</source>
        <translation>请提供包围器官的封闭曲面</translation>
    </message>
    <message>
        <source>Give a closed triangle surface.</source>
        <translation>请提供封闭的三角形曲面</translation>
    </message>
    <message>
        <source>Give a file with a surface, not points or lines</source>
        <translation>请提供含曲面的文件，而非仅含点或线</translation>
    </message>
    <message>
        <source>Give a fraction between 0 and 1.</source>
        <translation>请填写 0 与 1 之间的小数</translation>
    </message>
    <message>
        <source>Give a number between %1 and %2.</source>
        <translation>请填写 %1 与 %2 之间的数</translation>
    </message>
    <message>
        <source>Give a reason; whoever has a group keeps it</source>
        <translation>请说明理由；已分组者保持原组</translation>
    </message>
    <message>
        <source>Give a warning time above 0 and below the lock time</source>
        <translation>请填写大于 0 且小于锁定时间的提醒时间</translation>
    </message>
    <message>
        <source>Give an earlier time, or longer phases</source>
        <translation>请填写更早的时间，或延长阶段</translation>
    </message>
    <message>
        <source>Give another number of seconds</source>
        <translation>请填写其他秒数</translation>
    </message>
    <message>
        <source>Give both ends.</source>
        <translation>请同时给出两端</translation>
    </message>
    <message>
        <source>Give each the time of the last or a later one</source>
        <translation>请使每个时间不早于前一个</translation>
    </message>
    <message>
        <source>Give each column a name of its own</source>
        <translation>请为每列使用不同的名称</translation>
    </message>
    <message>
        <source>Give each group a short code, such as G1</source>
        <translation>请为每组填写简短代码，例如 G1</translation>
    </message>
    <message>
        <source>Give end points inside the organ.</source>
        <translation>请给出器官内部的端点</translation>
    </message>
    <message>
        <source>Give finite numbers.</source>
        <translation>请给出有限的数</translation>
    </message>
    <message>
        <source>Give it a short one, such as G1</source>
        <translation>请填写简短代码，例如 G1</translation>
    </message>
    <message>
        <source>Give it a short one, such as M1</source>
        <translation>请填写简短代码，例如 M1</translation>
    </message>
    <message>
        <source>Give it another code, or change the existing one</source>
        <translation>请换一个代码，或修改已有的记录</translation>
    </message>
    <message>
        <source>Give it in %1</source>
        <translation>请以 %1 为单位</translation>
    </message>
    <message>
        <source>Give it one, such as &quot;virtual 0-20 min&quot;</source>
        <translation>请填写名称，例如“虚拟 0–20 分钟”</translation>
    </message>
    <message>
        <source>Give more of the id</source>
        <translation>请输入更完整的编号</translation>
    </message>
    <message>
        <source>Give one value a column and write decimals with a point</source>
        <translation>请每列填写一个值，小数使用点号</translation>
    </message>
    <message>
        <source>Give one value a column; put a value that holds the separator in quotes</source>
        <translation>请每列填写一个值；含分隔符的值请加引号</translation>
    </message>
    <message>
        <source>Give one, like --out pictures</source>
        <translation>请指定一个，例如 --out pictures</translation>
    </message>
    <message>
        <source>Give other end points, or check the mesh for handles.</source>
        <translation>请给出其他端点，或检查网格是否有环柄</translation>
    </message>
    <message>
        <source>Give the class a weight, or leave the rater out</source>
        <translation>请为该类设置权重，或不邀请该评分者</translation>
    </message>
    <message>
        <source>Give the computer, the database and the account</source>
        <translation>请填写计算机、数据库和账户</translation>
    </message>
    <message>
        <source>Give the curriculum as many arms as the cohort has groups</source>
        <translation>课程的组别数应与批次的组数相同</translation>
    </message>
    <message>
        <source>Give the file the extension of its format, or export it again</source>
        <translation>请使用与格式相符的扩展名，或重新导出</translation>
    </message>
    <message>
        <source>Give the path of a database file</source>
        <translation>请给出数据库文件的路径</translation>
    </message>
    <message>
        <source>Give the two end points.</source>
        <translation>请给出两个端点</translation>
    </message>
    <message>
        <source>Give the version of the consent text</source>
        <translation>请给出同意书的版本</translation>
    </message>
    <message>
        <source>Give three finite numbers.</source>
        <translation>请给出三个有限的数</translation>
    </message>
    <message>
        <source>Give two end points further apart.</source>
        <translation>请给出相距更远的两个端点</translation>
    </message>
    <message>
        <source>Go on with the next case of the queue</source>
        <translation>请继续待评列表中的下一个案例</translation>
    </message>
    <message>
        <source>Go on with the next model</source>
        <translation>请继续下一个模型</translation>
    </message>
    <message>
        <source>Haptic device</source>
        <translation>力反馈设备</translation>
    </message>
    <message>
        <source>Hold the stylus: it will push upwards with %1 N for %2 s</source>
        <translation>请握住手写笔：将以 %1 N 向上推 %2 秒</translation>
    </message>
    <message>
        <source>Importing</source>
        <translation>正在导入</translation>
    </message>
    <message>
        <source>Install OpenHaptics 3.0 to 3.5; this file is another library or an incomplete one</source>
        <translation>请安装 OpenHaptics 3.0 至 3.5；该文件属于其他程序库或不完整</translation>
    </message>
    <message>
        <source>Install the device&apos;s driver and the OpenHaptics run time (docs/devices.md), or name the library with --library</source>
        <translation>请安装设备驱动和 OpenHaptics 运行库（docs/devices.md），或用 --library 指定程序库</translation>
    </message>
    <message>
        <source>Install the device&apos;s driver package; OpenHaptics alone is not enough</source>
        <translation>请安装设备驱动包；仅有 OpenHaptics 不够</translation>
    </message>
    <message>
        <source>Install the driver package that belongs to it, for this kind of processor</source>
        <translation>请安装与之配套、适用于本机处理器的驱动包</translation>
    </message>
    <message>
        <source>Install the licence of OpenHaptics for this computer, or set OH_SDK_LICENSE_PATH to its folder</source>
        <translation>请安装本机的 OpenHaptics 许可证，或将 OH_SDK_LICENSE_PATH 设为其所在文件夹</translation>
    </message>
    <message>
        <source>Install the package %1</source>
        <translation>请安装软件包 %1</translation>
    </message>
    <message>
        <source>Install the package that contains %1</source>
        <translation>请安装包含 %1 的软件包</translation>
    </message>
    <message>
        <source>Install the packages libncurses5 and libtinfo5</source>
        <translation>请安装软件包 libncurses5 和 libtinfo5</translation>
    </message>
    <message>
        <source>Intestine: hold the turn</source>
        <translation>肠：保持扭转</translation>
    </message>
    <message>
        <source>Intestine: turn a held loop by 180 degrees</source>
        <translation>肠：将夹持的肠袢扭转 180 度</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>抖动</translation>
    </message>
    <message>
        <source>Join them</source>
        <translation>请将其合并</translation>
    </message>
    <message>
        <source>Keep one of the two</source>
        <translation>请保留其中之一</translation>
    </message>
    <message>
        <source>Keep one of the two rules</source>
        <translation>请保留两条标准中的一条</translation>
    </message>
    <message>
        <source>Keep one organ only</source>
        <translation>请只保留一个器官</translation>
    </message>
    <message>
        <source>Keep what you have here and compare the two</source>
        <translation>请保留现有内容，并比较两者</translation>
    </message>
    <message>
        <source>Knows the steps, corrects often</source>
        <translation>知道步骤，经常修正</translation>
    </message>
    <message>
        <source>Laying out the desks</source>
        <translation>正在布置工作台</translation>
    </message>
    <message>
        <source>Leave them out</source>
        <translation>请将其去掉</translation>
    </message>
    <message>
        <source>Let the device rest for a while</source>
        <translation>请让设备休息片刻</translation>
    </message>
    <message>
        <source>Let the device rest, calibrate it again and repeat the check</source>
        <translation>请让设备休息并重新校准，然后再次检查</translation>
    </message>
    <message>
        <source>Let the run come to its end, close Torsio at all other stations, wait half a minute, and try again</source>
        <translation>请等待操作结束，关闭其他所有工作站上的 Torsio，等待半分钟后重试</translation>
    </message>
    <message>
        <source>Let the server&apos;s administrator make an empty database</source>
        <translation>请让服务器管理员创建一个空数据库</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>程序库</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>许可证</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>List the campaigns first</source>
        <translation>请先列出模型评价</translation>
    </message>
    <message>
        <source>Lock a design and allocate first</source>
        <translation>请先锁定方案并分组</translation>
    </message>
    <message>
        <source>Lock after %1 to %2 minutes, and warn at least one minute before</source>
        <translation>锁定时间为 %1 至 %2 分钟，并至少提前一分钟提醒</translation>
    </message>
    <message>
        <source>Lock one first</source>
        <translation>请先锁定一个方案</translation>
    </message>
    <message>
        <source>Look at the preview again</source>
        <translation>请重新查看预览</translation>
    </message>
    <message>
        <source>Looking for the device</source>
        <translation>正在查找设备</translation>
    </message>
    <message>
        <source>M01 cannot be read</source>
        <translation>M01 无法读取</translation>
    </message>
    <message>
        <source>M01 no such file</source>
        <translation>M01 没有该文件</translation>
    </message>
    <message>
        <source>M01 not a file</source>
        <translation>M01 不是文件</translation>
    </message>
    <message>
        <source>M01 the file is empty</source>
        <translation>M01 文件为空</translation>
    </message>
    <message>
        <source>M02 files with the extension &quot;%1&quot; are not read</source>
        <translation>M02 不支持扩展名为“%1”的文件</translation>
    </message>
    <message>
        <source>M02 not a file of the format %1: %2</source>
        <translation>M02 不是 %1 格式的文件：%2</translation>
    </message>
    <message>
        <source>M03 %1 triangles, at most %2 are accepted</source>
        <translation>M03 有 %1 个三角形，最多接受 %2 个</translation>
    </message>
    <message>
        <source>M03 more than %1 triangles</source>
        <translation>M03 三角形超过 %1 个</translation>
    </message>
    <message>
        <source>M03 the file has more than %1 MB</source>
        <translation>M03 文件超过 %1 MB</translation>
    </message>
    <message>
        <source>M05 %1 is broken: %2</source>
        <translation>M05 %1 已损坏：%2</translation>
    </message>
    <message>
        <source>M05 the importer failed on this file: %1</source>
        <translation>M05 导入该文件失败：%1</translation>
    </message>
    <message>
        <source>M06 no triangles</source>
        <translation>M06 没有三角形</translation>
    </message>
    <message>
        <source>M06 the file declares no vertices with x, y, z or no faces</source>
        <translation>M06 文件未声明含 x、y、z 的顶点或没有面</translation>
    </message>
    <message>
        <source>M07 vertex %1 is not a finite number</source>
        <translation>M07 顶点 %1 不是有限的数</translation>
    </message>
    <message>
        <source>M07 vertex %1 lies at %2, further than %3 from the origin</source>
        <translation>M07 顶点 %1 位于 %2，距原点超过 %3</translation>
    </message>
    <message>
        <source>M08 %1 uses vertex %2 of %3</source>
        <translation>M08 %1 使用了顶点 %2，共有 %3 个</translation>
    </message>
    <message>
        <source>M08 face %1 uses vertex %2 of %3</source>
        <translation>M08 面 %1 使用了顶点 %2，共有 %3 个</translation>
    </message>
    <message>
        <source>M09 largest side %1 is no organ (%2 to %3)</source>
        <translation>M09 最大边长 %1 不符合器官尺寸（%2 至 %3）</translation>
    </message>
    <message>
        <source>M09 largest side %1: the file seems to be in %2</source>
        <translation>M09 最大边长 %1：文件单位似乎为 %2</translation>
    </message>
    <message>
        <source>M13 the surface is one-sided (like a Moebius strip)</source>
        <translation>M13 曲面为单侧曲面（如莫比乌斯带）</translation>
    </message>
    <message>
        <source>M14 separate pieces hold %1 % of the surface</source>
        <translation>M14 分离的部分占曲面的 %1 %</translation>
    </message>
    <message>
        <source>M18 the surface is flat: mean thickness %1, volume %2 ml</source>
        <translation>M18 曲面过扁：平均厚度 %1，体积 %2 ml</translation>
    </message>
    <message>
        <source>M19 too coarse: %1 triangles, at least %2 are needed</source>
        <translation>M19 过于粗糙：%1 个三角形，至少需要 %2 个</translation>
    </message>
    <message>
        <source>Make an empty database on the server and copy again</source>
        <translation>请在服务器上创建空数据库后重新复制</translation>
    </message>
    <message>
        <source>Make another cohort for the other curriculum</source>
        <translation>请为另一课程新建批次</translation>
    </message>
    <message>
        <source>Make somebody else an administrator first</source>
        <translation>请先将其他人设为管理员</translation>
    </message>
    <message>
        <source>Make the demonstration people first</source>
        <translation>请先创建演示人员</translation>
    </message>
    <message>
        <source>Measuring the servo for %1 s</source>
        <translation>正在测量伺服，共 %1 秒</translation>
    </message>
    <message>
        <source>Model &quot;%1&quot; is not an Omni or Touch; it is treated like a Touch</source>
        <translation>型号“%1”不是 Omni 或 Touch；按 Touch 处理</translation>
    </message>
    <message>
        <source>Motors</source>
        <translation>电机</translation>
    </message>
    <message>
        <source>Mouse and keyboard</source>
        <translation>鼠标和键盘</translation>
    </message>
    <message>
        <source>Move it, or widen the scale</source>
        <translation>请移动它，或扩大量表范围</translation>
    </message>
    <message>
        <source>Move the end point into the organ or turn the direction of the cut.</source>
        <translation>请将端点移入器官内，或改变切割方向</translation>
    </message>
    <message>
        <source>Move the end points inwards, or give the end points of the axis.</source>
        <translation>请将端点向内移，或给出轴线的端点</translation>
    </message>
    <message>
        <source>Move the end points so that the axis follows the organ, or cut the organ at the kink.</source>
        <translation>请移动端点使轴线沿器官走行，或在弯折处切断器官</translation>
    </message>
    <message>
        <source>Move the end points so that the axis follows the organ, or smooth the mesh.</source>
        <translation>请移动端点使轴线沿器官走行，或平滑网格</translation>
    </message>
    <message>
        <source>Name a file in that folder</source>
        <translation>请指定该文件夹中的文件</translation>
    </message>
    <message>
        <source>Name a mesh file, not a folder</source>
        <translation>请指定网格文件，而不是文件夹</translation>
    </message>
    <message>
        <source>Name a new file, or an empty database</source>
        <translation>请指定新文件或空数据库</translation>
    </message>
    <message>
        <source>Name a new folder</source>
        <translation>请指定新文件夹</translation>
    </message>
    <message>
        <source>Name another target</source>
        <translation>请指定其他目标</translation>
    </message>
    <message>
        <source>Name at least two models</source>
        <translation>请至少列出两个模型</translation>
    </message>
    <message>
        <source>Name each once</source>
        <translation>每项只列一次</translation>
    </message>
    <message>
        <source>Name it NNNN_what.sql and write -- compatible_from: N</source>
        <translation>请命名为 NNNN_what.sql，并写明 -- compatible_from: N</translation>
    </message>
    <message>
        <source>Name its groups, or choose a curriculum whose arms they follow</source>
        <translation>请列出其组别，或选择与组别相符的课程</translation>
    </message>
    <message>
        <source>Near the angle, wavers</source>
        <translation>接近目标角度，有摆动</translation>
    </message>
    <message>
        <source>Nothing is recorded any more</source>
        <translation>不再录制任何内容</translation>
    </message>
    <message>
        <source>Nothing is to be done</source>
        <translation>无需处理</translation>
    </message>
    <message>
        <source>Open a case of your own queue</source>
        <translation>请打开您自己待评列表中的案例</translation>
    </message>
    <message>
        <source>Open both with this version of Torsio first</source>
        <translation>请先用此版本的 Torsio 打开两者</translation>
    </message>
    <message>
        <source>Open it for writing, or copy it to a writable folder</source>
        <translation>请以可写方式打开，或复制到可写的文件夹</translation>
    </message>
    <message>
        <source>Open it once for writing, so that it can be brought up to date</source>
        <translation>请先以可写方式打开一次，以便更新</translation>
    </message>
    <message>
        <source>Open one of your own</source>
        <translation>请打开您自己的一项</translation>
    </message>
    <message>
        <source>Open that person, or correct the number</source>
        <translation>请打开该人员，或更正编号</translation>
    </message>
    <message>
        <source>Open the consent again</source>
        <translation>请重新打开同意书</translation>
    </message>
    <message>
        <source>Open the form again</source>
        <translation>请重新打开评价表</translation>
    </message>
    <message>
        <source>Open the list again</source>
        <translation>请重新打开列表</translation>
    </message>
    <message>
        <source>Open the organ file of the recording first, or use the version that recorded it: %1</source>
        <translation>请先打开该录制的器官文件，或使用录制时的版本：%1</translation>
    </message>
    <message>
        <source>Open the sheet again</source>
        <translation>请重新打开评分表</translation>
    </message>
    <message>
        <source>Open rater calibration again</source>
        <translation>请重新打开评分校准</translation>
    </message>
    <message>
        <source>Open your own record</source>
        <translation>请打开您自己的记录</translation>
    </message>
    <message>
        <source>Operational accuracy</source>
        <translation>操作准确性</translation>
    </message>
    <message>
        <source>PIN</source>
        <translation>PIN 码</translation>
    </message>
    <message>
        <source>Paper protocol: three arms</source>
        <translation>论文方案：三组</translation>
    </message>
    <message>
        <source>Period and damping lie above zero, the latency in 0..16 ticks</source>
        <translation>周期和阻尼须大于零，延迟为 0 至 16 个周期</translation>
    </message>
    <message>
        <source>Play it again at an allowed speed</source>
        <translation>请以允许的速度重新播放</translation>
    </message>
    <message>
        <source>Play the rest before you submit</source>
        <translation>请看完其余部分再提交</translation>
    </message>
    <message>
        <source>Point TORSIO_ASSETS at the assets folder, or unset it</source>
        <translation>请将 TORSIO_ASSETS 指向资源文件夹，或取消设置</translation>
    </message>
    <message>
        <source>Practice on forearm, intestine and stomach, from an easy pronation to the combined gastric twist. Each step opens when the one before is mastered: enough twists let go on the target, several times in a row.</source>
        <translation>在前臂、肠和胃上练习，从简单的旋前到胃的复合扭转。掌握前一步后才开放下一步：连续多次在目标处松开足够数量的扭转。</translation>
    </message>
    <message>
        <source>Practise, or put right what the device check shows</source>
        <translation>请先练习，或处理设备检查中列出的问题</translation>
    </message>
    <message>
        <source>Proficiency</source>
        <translation>熟练程度</translation>
    </message>
    <message>
        <source>Put it in brackets.</source>
        <translation>请加上方括号</translation>
    </message>
    <message>
        <source>Put it in quotes.</source>
        <translation>请加上引号</translation>
    </message>
    <message>
        <source>Put the line shown here into the password file of this computer&apos;s account</source>
        <translation>请将此处显示的一行写入本机账户的密码文件</translation>
    </message>
    <message>
        <source>Put the stylus firmly into the inkwell and repeat the check</source>
        <translation>请将手写笔牢固插入笔座，然后再次检查</translation>
    </message>
    <message>
        <source>Put the stylus into the inkwell and leave it there</source>
        <translation>请将手写笔插入笔座并保持不动</translation>
    </message>
    <message>
        <source>Put the stylus into the inkwell and repeat the check</source>
        <translation>请将手写笔插入笔座，然后再次检查</translation>
    </message>
    <message>
        <source>Put the whole value in quotes and double each quote in it</source>
        <translation>请将整个值加引号，并将其中的引号写两遍</translation>
    </message>
    <message>
        <source>Qt has no driver %1</source>
        <translation>Qt 没有 %1 驱动</translation>
    </message>
    <message>
        <source>Quit Torsio, plug the device in again and start anew</source>
        <translation>请退出 Torsio，重新插拔设备后再开始</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>Reaches and holds the angle</source>
        <translation>达到并保持角度</translation>
    </message>
    <message>
        <source>Read and confirm the consent first, or use free practice, which is not recorded</source>
        <translation>请先阅读并确认同意书，或使用不录制的自由练习</translation>
    </message>
    <message>
        <source>Read the draft again and merge your changes</source>
        <translation>请重新读取草稿并合并您的更改</translation>
    </message>
    <message>
        <source>Read the list again</source>
        <translation>请重新读取列表</translation>
    </message>
    <message>
        <source>Read the list again and repeat</source>
        <translation>请重新读取列表后再试</translation>
    </message>
    <message>
        <source>Read the matrix again</source>
        <translation>请重新读取评分矩阵</translation>
    </message>
    <message>
        <source>Read the queue again</source>
        <translation>请重新读取待评列表</translation>
    </message>
    <message>
        <source>Reading marks</source>
        <translation>正在读取评分</translation>
    </message>
    <message>
        <source>Reading recording %1 of %2</source>
        <translation>正在读取第 %1 条录制，共 %2 条</translation>
    </message>
    <message>
        <source>Record it for the phase that it was spent in</source>
        <translation>请记入实际所用的阶段</translation>
    </message>
    <message>
        <source>Record the time without a phase</source>
        <translation>请不指定阶段来登记时间</translation>
    </message>
    <message>
        <source>Reduce the surface to half a million triangles or fewer</source>
        <translation>请将曲面减少到五十万个三角形以内</translation>
    </message>
    <message>
        <source>Remesh the surface</source>
        <translation>请重新划分曲面网格</translation>
    </message>
    <message>
        <source>Remove inner or doubled faces in a mesh editor</source>
        <translation>请在网格编辑器中删除内部或重叠的面</translation>
    </message>
    <message>
        <source>Remove it from its own prerequisites</source>
        <translation>请将其从自身的先修模块中移除</translation>
    </message>
    <message>
        <source>Remove it, or check its spelling.</source>
        <translation>请将其删除，或检查拼写</translation>
    </message>
    <message>
        <source>Remove one of the two lines, or correct the number</source>
        <translation>请删除两行中的一行，或更正编号</translation>
    </message>
    <message>
        <source>Remove one of them</source>
        <translation>请删除其中之一</translation>
    </message>
    <message>
        <source>Remove one prerequisite</source>
        <translation>请移除一个先修模块</translation>
    </message>
    <message>
        <source>Remove the module</source>
        <translation>请移除该模块</translation>
    </message>
    <message>
        <source>Remove the vertex or export the mesh again</source>
        <translation>请删除该顶点，或重新导出网格</translation>
    </message>
    <message>
        <source>Rename one</source>
        <translation>请将其中之一改名</translation>
    </message>
    <message>
        <source>Rename one of them</source>
        <translation>请将其中之一改名</translation>
    </message>
    <message>
        <source>Rename one.</source>
        <translation>请将其中之一改名</translation>
    </message>
    <message>
        <source>Repair the faces in a mesh editor</source>
        <translation>请在网格编辑器中修复面</translation>
    </message>
    <message>
        <source>Repair the installation</source>
        <translation>请修复安装</translation>
    </message>
    <message>
        <source>Repeat the check</source>
        <translation>请再次检查</translation>
    </message>
    <message>
        <source>Repeat the check and hold the stylus</source>
        <translation>请握住手写笔，再次检查</translation>
    </message>
    <message>
        <source>Repeat the device check, or practise with mouse and keyboard</source>
        <translation>请再次检查设备，或用鼠标和键盘练习</translation>
    </message>
    <message>
        <source>Repeat the whole change</source>
        <translation>请重做整个更改</translation>
    </message>
    <message>
        <source>Rest the stylus in the inkwell for a moment before training</source>
        <translation>训练前请将手写笔在笔座中放置片刻</translation>
    </message>
    <message>
        <source>Restore it from the installation</source>
        <translation>请从安装文件恢复</translation>
    </message>
    <message>
        <source>Restore the file from the installation</source>
        <translation>请从安装文件恢复该文件</translation>
    </message>
    <message>
        <source>Restore the latest backup</source>
        <translation>请恢复最近的备份</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Run it on a desktop, or through xvfb-run with QT_QPA_PLATFORM=xcb</source>
        <translation>请在桌面环境中运行，或通过 xvfb-run 并设置 QT_QPA_PLATFORM=xcb</translation>
    </message>
    <message>
        <source>Run the check of the allocation before anybody else is allocated</source>
        <translation>请先核对分组，再为其他人分组</translation>
    </message>
    <message>
        <source>Run torsio audit verify on it and restore a backup</source>
        <translation>请对其运行 torsio audit verify 并恢复备份</translation>
    </message>
    <message>
        <source>Save the table as UTF-8 CSV</source>
        <translation>请将表格保存为 UTF-8 编码的 CSV</translation>
    </message>
    <message>
        <source>Save the table with commas and decimal points</source>
        <translation>请使用逗号分隔、点号小数保存表格</translation>
    </message>
    <message>
        <source>Say in a few words what happened</source>
        <translation>请简要说明发生了什么</translation>
    </message>
    <message>
        <source>Say in a few words what is practised</source>
        <translation>请简要说明练习内容</translation>
    </message>
    <message>
        <source>Say in a few words what it goes through</source>
        <translation>请简要说明该组的经历</translation>
    </message>
    <message>
        <source>Say in a few words why</source>
        <translation>请简要说明理由</translation>
    </message>
    <message>
        <source>Say what the mark means</source>
        <translation>请说明该评分的含义</translation>
    </message>
    <message>
        <source>Say why</source>
        <translation>请说明理由</translation>
    </message>
    <message>
        <source>Say why, for the audit trail</source>
        <translation>请说明理由，以便记入审计记录</translation>
    </message>
    <message>
        <source>Scale the mesh to life size</source>
        <translation>请将网格缩放到真实大小</translation>
    </message>
    <message>
        <source>Score from the traces, or ask an administrator for the organ file</source>
        <translation>请依据曲线评分，或向管理员索取器官文件</translation>
    </message>
    <message>
        <source>Searches for the grip</source>
        <translation>寻找夹持位置</translation>
    </message>
    <message>
        <source>Separate or join the parts in a mesh editor</source>
        <translation>请在网格编辑器中分离或合并各部分</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>伺服</translation>
    </message>
    <message>
        <source>Set TORSIO_ASSETS to the assets folder</source>
        <translation>请将 TORSIO_ASSETS 设为资源文件夹</translation>
    </message>
    <message>
        <source>Set the person to &quot;left&quot; instead</source>
        <translation>请改为将此人设为“已离开”</translation>
    </message>
    <message>
        <source>Shorten it</source>
        <translation>请缩短</translation>
    </message>
    <message>
        <source>Shutdown</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Sign in first</source>
        <translation>请先登录</translation>
    </message>
    <message>
        <source>Sign in with your password to change it</source>
        <translation>请用密码登录后再更改</translation>
    </message>
    <message>
        <source>Sign in, or choose another database</source>
        <translation>请登录，或选择其他数据库</translation>
    </message>
    <message>
        <source>Soft build-up, soft release</source>
        <translation>轻柔加力，轻柔松开</translation>
    </message>
    <message>
        <source>Some force peaks</source>
        <translation>有些力的峰值</translation>
    </message>
    <message>
        <source>Split the evaluation</source>
        <translation>请拆分该评价</translation>
    </message>
    <message>
        <source>Start Torsio again at this station, which stores them, then try again</source>
        <translation>请在本工作站重新启动 Torsio 以完成存储，然后重试</translation>
    </message>
    <message>
        <source>Start it first, or choose another version</source>
        <translation>请先启用，或选择其他版本</translation>
    </message>
    <message>
        <source>Start it on a desktop, or through xvfb-run; commands such as &apos;torsio demo&apos; need no display</source>
        <translation>请在桌面环境中启动，或通过 xvfb-run；“torsio demo”等命令无需显示器</translation>
    </message>
    <message>
        <source>Stomach: antrum only, 90 degrees</source>
        <translation>胃：仅胃窦，90 度</translation>
    </message>
    <message>
        <source>Stomach: combined twist, graded</source>
        <translation>胃：复合扭转，计分</translation>
    </message>
    <message>
        <source>Stomach: organo-axial, 180 degrees</source>
        <translation>胃：器官轴型，180 度</translation>
    </message>
    <message>
        <source>Subdivide the surface</source>
        <translation>请细分曲面</translation>
    </message>
    <message>
        <source>Submitted marks stay; amend the mark instead</source>
        <translation>已提交的评分保持不变；请改用修订</translation>
    </message>
    <message>
        <source>Take a longer one</source>
        <translation>请使用更长的密码</translation>
    </message>
    <message>
        <source>Take a sentence of your own</source>
        <translation>请使用您自己的句子</translation>
    </message>
    <message>
        <source>Take a sentence: spaces and any letters are welcome</source>
        <translation>请使用一个句子：空格和任何文字均可</translation>
    </message>
    <message>
        <source>Take the instrument that was installed with the program</source>
        <translation>请使用随程序安装的器械</translation>
    </message>
    <message>
        <source>Take the stylus out of the inkwell and hold it in the middle of the workspace</source>
        <translation>请将手写笔从笔座取出，握在工作空间中央</translation>
    </message>
    <message>
        <source>Tears and jerks</source>
        <translation>牵拉、猛拽</translation>
    </message>
    <message>
        <source>The device does not report motor temperatures</source>
        <translation>设备不报告电机温度</translation>
    </message>
    <message>
        <source>The device refused to take its present position as the reference</source>
        <translation>设备拒绝以当前位置为参考</translation>
    </message>
    <message>
        <source>The device says that it renders %1 axes; an Omni or Touch renders 3. Forces are rendered along three axes, with cautious limits</source>
        <translation>设备声称可输出 %1 个轴；Omni 或 Touch 为 3 个轴。将以保守限值沿三个轴输出力</translation>
    </message>
    <message>
        <source>The file is damaged or cut off: export it again</source>
        <translation>文件已损坏或不完整：请重新导出</translation>
    </message>
    <message>
        <source>The library keeps its own servo rate</source>
        <translation>程序库保持自身的伺服频率</translation>
    </message>
    <message>
        <source>The recording is kept in a file until it does</source>
        <translation>在此之前录制保存在文件中</translation>
    </message>
    <message>
        <source>This program reads %1.</source>
        <translation>此程序读取 %1</translation>
    </message>
    <message>
        <source>Three groups train for 40 minutes: all virtual, half virtual and half on the real arm, all real. Marks before, after 20 and after 40 minutes, always on the real arm. Each trainee may rest once for 5 minutes.</source>
        <translation>三组各训练 40 分钟：全部虚拟；一半虚拟、一半实物手臂；全部实物手臂。训练前、20 分钟后和 40 分钟后均在实物手臂上评分。每位学员可休息一次，5 分钟。</translation>
    </message>
    <message>
        <source>Training time</source>
        <translation>训练时间</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Try again in a moment</source>
        <translation>请稍后重试</translation>
    </message>
    <message>
        <source>Try again on a faster display</source>
        <translation>请在更快的显示设备上重试</translation>
    </message>
    <message>
        <source>Try again, or tell an administrator</source>
        <translation>请重试，或告知管理员</translation>
    </message>
    <message>
        <source>Trying it out</source>
        <translation>正在试运行</translation>
    </message>
    <message>
        <source>Twist the forearm to 60 degrees, pronation</source>
        <translation>将前臂旋前 60 度</translation>
    </message>
    <message>
        <source>Twist training</source>
        <translation>扭转训练</translation>
    </message>
    <message>
        <source>Unplug the device, plug it in again and run the vendor&apos;s set-up tool</source>
        <translation>请拔下设备，重新插上，再运行厂商的设置工具</translation>
    </message>
    <message>
        <source>Unplug the device, wait ten seconds, plug it in again and run the vendor&apos;s set-up tool</source>
        <translation>请拔下设备，等待十秒，重新插上，再运行厂商的设置工具</translation>
    </message>
    <message>
        <source>Update Torsio on this machine</source>
        <translation>请更新本机的 Torsio</translation>
    </message>
    <message>
        <source>Update Torsio on this machine, or restore a backup</source>
        <translation>请更新此计算机上的 Torsio，或恢复备份</translation>
    </message>
    <message>
        <source>Use a display with OpenGL</source>
        <translation>请使用支持 OpenGL 的显示设备</translation>
    </message>
    <message>
        <source>Use an older backup</source>
        <translation>请使用更早的备份</translation>
    </message>
    <message>
        <source>Use en or zh_CN</source>
        <translation>请使用 en 或 zh_CN</translation>
    </message>
    <message>
        <source>Use letters and digits</source>
        <translation>请使用字母和数字</translation>
    </message>
    <message>
        <source>Use light or dark</source>
        <translation>请使用 light 或 dark</translation>
    </message>
    <message>
        <source>Use lower-case letters, digits and underscores only</source>
        <translation>只能使用小写字母、数字和下划线</translation>
    </message>
    <message>
        <source>Use m, cm, mm or um</source>
        <translation>请使用 m、cm、mm 或 um</translation>
    </message>
    <message>
        <source>Use obj, stl, ply, off, glb, gltf or dae</source>
        <translation>请使用 obj、stl、ply、off、glb、gltf 或 dae</translation>
    </message>
    <message>
        <source>Use pg_dump --format=custom --file=FILE on the server</source>
        <translation>请在服务器上使用 pg_dump --format=custom --file=FILE</translation>
    </message>
    <message>
        <source>Use pg_restore on the server</source>
        <translation>请在服务器上使用 pg_restore</translation>
    </message>
    <message>
        <source>Use the assigned rubric</source>
        <translation>请使用指定的评分标准</translation>
    </message>
    <message>
        <source>Use the live sheet</source>
        <translation>请使用现场评分表</translation>
    </message>
    <message>
        <source>Use the program that made this database, or restore a backup</source>
        <translation>请使用创建该数据库的程序，或恢复备份</translation>
    </message>
    <message>
        <source>Use trainee, rater or administrator</source>
        <translation>请使用 trainee、rater 或 administrator</translation>
    </message>
    <message>
        <source>Use trainee, rater, left or consent_withdrawn</source>
        <translation>请使用 trainee、rater、left 或 consent_withdrawn</translation>
    </message>
    <message>
        <source>Verify the database</source>
        <translation>请校验数据库</translation>
    </message>
    <message>
        <source>Wait for them, or give a reason</source>
        <translation>请等待他们，或说明理由</translation>
    </message>
    <message>
        <source>Wait until all have committed</source>
        <translation>请等待所有人提交</translation>
    </message>
    <message>
        <source>Write %1, or leave the cell empty</source>
        <translation>请填写%1，或将单元格留空</translation>
    </message>
    <message>
        <source>Write [ ... ].</source>
        <translation>请写成 [ ... ]</translation>
    </message>
    <message>
        <source>Write [x, y, z].</source>
        <translation>请写成 [x, y, z]</translation>
    </message>
    <message>
        <source>Write a decimal number with a point, such as 7.5</source>
        <translation>请填写以点号作小数点的数，例如 7.5</translation>
    </message>
    <message>
        <source>Write a whole number from %1 to %2, or leave the cell empty</source>
        <translation>请填写 %1 至 %2 的整数，或将单元格留空</translation>
    </message>
    <message>
        <source>Write it in a few words</source>
        <translation>请简要填写</translation>
    </message>
    <message>
        <source>Write it into the comment of the sheet</source>
        <translation>请写入评分表的评论</translation>
    </message>
    <message>
        <source>Write sizes like 1366x768,1920x1080</source>
        <translation>请写成 1366x768,1920x1080 的形式</translation>
    </message>
    <message>
        <source>Write what you want to say</source>
        <translation>请写下您想说的话</translation>
    </message>
    <message>
        <source>Write why you change it</source>
        <translation>请写明更改的理由</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>正在生成报告</translation>
    </message>
    <message>
        <source>Your own marks stay as they are</source>
        <translation>您自己的评分保持不变</translation>
    </message>
    <message>
        <source>a PostgreSQL database is backed up and restored by its own tools</source>
        <translation>PostgreSQL 数据库须用其自带工具备份和恢复</translation>
    </message>
    <message>
        <source>a cap of the organ is no disc</source>
        <translation>器官的一个端盖不是圆盘</translation>
    </message>
    <message>
        <source>a curriculum that is %1 cannot become %2</source>
        <translation>状态为“%1”的课程不能变为“%2”</translation>
    </message>
    <message>
        <source>a cut needs both end points</source>
        <translation>切割需要两个端点</translation>
    </message>
    <message>
        <source>a group has no code</source>
        <translation>有一组没有代码</translation>
    </message>
    <message>
        <source>a marker has no position of three numbers</source>
        <translation>有一个标记缺少由三个数表示的位置</translation>
    </message>
    <message>
        <source>a model has no code or no name</source>
        <translation>有一个模型缺少代码或名称</translation>
    </message>
    <message>
        <source>a panel has at least one member</source>
        <translation>专家组至少有一名成员</translation>
    </message>
    <message>
        <source>a part of a person cannot be taken away: records hang on it</source>
        <translation>人员的这部分信息不能移除：有记录依赖于它</translation>
    </message>
    <message>
        <source>a part of the recording is missing</source>
        <translation>录制缺少一部分</translation>
    </message>
    <message>
        <source>a phase or a rest has no sensible length</source>
        <translation>某个阶段或休息的时长不合理</translation>
    </message>
    <message>
        <source>a physician was asked about this recording by name</source>
        <translation>已就此录制向医师实名提问</translation>
    </message>
    <message>
        <source>a quote does not close</source>
        <translation>引号未闭合</translation>
    </message>
    <message>
        <source>a quote stands inside the value %1</source>
        <translation>值 %1 中含有引号</translation>
    </message>
    <message>
        <source>a rater is named twice</source>
        <translation>有一位评分者被列出两次</translation>
    </message>
    <message>
        <source>a reason is needed</source>
        <translation>需要说明理由</translation>
    </message>
    <message>
        <source>a required value is missing</source>
        <translation>缺少必填的值</translation>
    </message>
    <message>
        <source>a row has no code or no label</source>
        <translation>有一行缺少代码或名称</translation>
    </message>
    <message>
        <source>a run is going on at the station %1</source>
        <translation>工作站“%1”上有操作正在进行</translation>
    </message>
    <message>
        <source>a servo frame could not be opened or closed</source>
        <translation>无法打开或关闭伺服帧</translation>
    </message>
    <message>
        <source>a statement lacks its ;</source>
        <translation>语句缺少 ;</translation>
    </message>
    <message>
        <source>a submitted mark is changed with a reason only</source>
        <translation>已提交的评分只能附理由更改</translation>
    </message>
    <message>
        <source>a triangle refers to a vertex that does not exist</source>
        <translation>有三角形引用了不存在的顶点</translation>
    </message>
    <message>
        <source>a value breaks the rule of its column</source>
        <translation>有值违反了该列的规则</translation>
    </message>
    <message>
        <source>a vertex is not a finite point</source>
        <translation>有一个顶点不是有限的点</translation>
    </message>
    <message>
        <source>a withdrawal needs a reason</source>
        <translation>退出须说明理由</translation>
    </message>
    <message>
        <source>age</source>
        <translation>年龄</translation>
    </message>
    <message>
        <source>all phases of your training are over</source>
        <translation>您的训练阶段已全部结束</translation>
    </message>
    <message>
        <source>allocation</source>
        <translation>随机分组</translation>
    </message>
    <message>
        <source>allocation has begun with another design</source>
        <translation>已按另一方案开始分组</translation>
    </message>
    <message>
        <source>allocation number %1 does not follow %2</source>
        <translation>分组序号 %1 与 %2 不衔接</translation>
    </message>
    <message>
        <source>allows no force</source>
        <translation>不允许任何力</translation>
    </message>
    <message>
        <source>allows no torque</source>
        <translation>不允许任何扭矩</translation>
    </message>
    <message>
        <source>always there; a simulated hand with a seed</source>
        <translation>始终可用；带种子的模拟手</translation>
    </message>
    <message>
        <source>always there; repeats a recording tick by tick</source>
        <translation>始终可用；逐周期重放录制</translation>
    </message>
    <message>
        <source>always there; shows forces, does not render them</source>
        <translation>始终可用；显示力，但不输出力</translation>
    </message>
    <message>
        <source>always there; the instrument stays where it was put</source>
        <translation>始终可用；器械停在所放之处</translation>
    </message>
    <message>
        <source>an anchor has no words</source>
        <translation>有一个锚点没有文字</translation>
    </message>
    <message>
        <source>an anchor lies outside the scale</source>
        <translation>有一个锚点超出量表范围</translation>
    </message>
    <message>
        <source>an earlier step of this change failed: nothing was kept</source>
        <translation>此更改的前一步失败：未保留任何内容</translation>
    </message>
    <message>
        <source>an edge of the surface is open, used more than twice or runs the same way in both triangles</source>
        <translation>曲面有一条边未封闭、被使用两次以上，或在两个三角形中方向相同</translation>
    </message>
    <message>
        <source>an end point or cut direction of the organ is not finite</source>
        <translation>器官的端点或切割方向不是有限的数</translation>
    </message>
    <message>
        <source>an override needs a reason</source>
        <translation>人工调整须说明理由</translation>
    </message>
    <message>
        <source>another data set has this name</source>
        <translation>已有同名数据集</translation>
    </message>
    <message>
        <source>another station changed the same records at the same time</source>
        <translation>另一工作站同时更改了相同记录</translation>
    </message>
    <message>
        <source>arm &quot;%1&quot;</source>
        <translation>组别“%1”</translation>
    </message>
    <message>
        <source>arm %1</source>
        <translation>组别 %1</translation>
    </message>
    <message>
        <source>backup cannot be restored: %1</source>
        <translation>无法恢复备份：%1</translation>
    </message>
    <message>
        <source>backup cannot be written</source>
        <translation>无法写入备份</translation>
    </message>
    <message>
        <source>backup does not pass its check: %1</source>
        <translation>备份未通过检查：%1</translation>
    </message>
    <message>
        <source>backup is damaged: %1</source>
        <translation>备份已损坏：%1</translation>
    </message>
    <message>
        <source>calm, even and economical from first to last, adapts at once</source>
        <translation>自始至终沉稳、均匀、简练，能立即调整</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>无法读取</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>无法写入</translation>
    </message>
    <message>
        <source>case %1</source>
        <translation>案例 %1</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>cohort</source>
        <translation>批次</translation>
    </message>
    <message>
        <source>collision mesh</source>
        <translation>碰撞网格</translation>
    </message>
    <message>
        <source>comes later than any arm trains</source>
        <translation>晚于任何组别的训练时间</translation>
    </message>
    <message>
        <source>compares by &quot;%1&quot;</source>
        <translation>比较方式为“%1”</translation>
    </message>
    <message>
        <source>consent</source>
        <translation>同意书</translation>
    </message>
    <message>
        <source>continuous force</source>
        <translation>持续力</translation>
    </message>
    <message>
        <source>curriculum</source>
        <translation>课程</translation>
    </message>
    <message>
        <source>database</source>
        <translation>数据库</translation>
    </message>
    <message>
        <source>database cannot be opened</source>
        <translation>无法打开数据库</translation>
    </message>
    <message>
        <source>database file is read-only</source>
        <translation>数据库文件为只读</translation>
    </message>
    <message>
        <source>database is busy: another program is writing to it</source>
        <translation>数据库正忙：另一程序正在写入</translation>
    </message>
    <message>
        <source>database is damaged</source>
        <translation>数据库已损坏</translation>
    </message>
    <message>
        <source>database is open for reading only</source>
        <translation>数据库以只读方式打开</translation>
    </message>
    <message>
        <source>database refused the operation</source>
        <translation>数据库拒绝了该操作</translation>
    </message>
    <message>
        <source>database server cannot be reached: %1</source>
        <translation>无法连接数据库服务器：%1</translation>
    </message>
    <message>
        <source>database server does not answer</source>
        <translation>数据库服务器无响应</translation>
    </message>
    <message>
        <source>default device</source>
        <translation>默认设备</translation>
    </message>
    <message>
        <source>demonstration</source>
        <translation>演示</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>方案偏离</translation>
    </message>
    <message>
        <source>device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>device &quot;%1&quot;</source>
        <translation>设备“%1”</translation>
    </message>
    <message>
        <source>comes before the one that it follows</source>
        <translation>早于排在它前面的那个</translation>
    </message>
    <message>
        <source>does not finish, or needs far more time than is given</source>
        <translation>未完成，或远超规定时间</translation>
    </message>
    <message>
        <source>does not follow the entry before it</source>
        <translation>与前一条目不衔接</translation>
    </message>
    <message>
        <source>done in the inkwell</source>
        <translation>已在笔座中完成</translation>
    </message>
    <message>
        <source>enrolment</source>
        <translation>登记</translation>
    </message>
    <message>
        <source>entries before this one are missing</source>
        <translation>缺少此条目之前的条目</translation>
    </message>
    <message>
        <source>erase</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>erasing needs a reason</source>
        <translation>删除须说明理由</translation>
    </message>
    <message>
        <source>exposure</source>
        <translation>训练时间</translation>
    </message>
    <message>
        <source>field &apos;%1&apos; %2</source>
        <translation>字段“%1”%2</translation>
    </message>
    <message>
        <source>finishes in the time that is given, with few pauses</source>
        <translation>在规定时间内完成，停顿少</translation>
    </message>
    <message>
        <source>finishes quickly and steadily, no step too many</source>
        <translation>完成迅速而稳定，没有多余步骤</translation>
    </message>
    <message>
        <source>finishes slowly, with long pauses and repetitions</source>
        <translation>完成缓慢，停顿长，多次重复</translation>
    </message>
    <message>
        <source>first run</source>
        <translation>首次运行</translation>
    </message>
    <message>
        <source>folder cannot be created</source>
        <translation>无法创建文件夹</translation>
    </message>
    <message>
        <source>folder is read-only</source>
        <translation>文件夹为只读</translation>
    </message>
    <message>
        <source>force governor</source>
        <translation>力调节器</translation>
    </message>
    <message>
        <source>force up to %1 N, sustained %2 N, three axes, no torque about the stylus</source>
        <translation>力最大 %1 N，持续 %2 N，三个轴，无绕笔杆的扭矩</translation>
    </message>
    <message>
        <source>gave up waiting for %1</source>
        <translation>等待超时：%1</translation>
    </message>
    <message>
        <source>handedness</source>
        <translation>惯用手</translation>
    </message>
    <message>
        <source>haptic device</source>
        <translation>力反馈设备</translation>
    </message>
    <message>
        <source>has a pattern &quot;%1&quot; that the scene %2 lacks</source>
        <translation>的扭转类型“%1”在场景 %2 中不存在</translation>
    </message>
    <message>
        <source>has a target of 0 degrees</source>
        <translation>的目标为 0 度</translation>
    </message>
    <message>
        <source>has an older schema than this program</source>
        <translation>的结构版本比此程序旧</translation>
    </message>
    <message>
        <source>has an unknown scene &quot;%1&quot;</source>
        <translation>的场景“%1”无法识别</translation>
    </message>
    <message>
        <source>has neither modules nor arms</source>
        <translation>既无模块也无组别</translation>
    </message>
    <message>
        <source>has no code</source>
        <translation>没有代码</translation>
    </message>
    <message>
        <source>has no name</source>
        <translation>没有名称</translation>
    </message>
    <message>
        <source>has no phases</source>
        <translation>没有阶段</translation>
    </message>
    <message>
        <source>has no title</source>
        <translation>没有标题</translation>
    </message>
    <message>
        <source>has no tolerance</source>
        <translation>没有容差</translation>
    </message>
    <message>
        <source>has the code of another arm</source>
        <translation>与另一组别的代码相同</translation>
    </message>
    <message>
        <source>has the code of another module</source>
        <translation>与另一模块的代码相同</translation>
    </message>
    <message>
        <source>has withdrawn from the study</source>
        <translation>已退出研究</translation>
    </message>
    <message>
        <source>holds no Torsio record</source>
        <translation>不含 Torsio 记录</translation>
    </message>
    <message>
        <source>idle lock</source>
        <translation>空闲锁定</translation>
    </message>
    <message>
        <source>is &apos;%1&apos;</source>
        <translation>为“%1”</translation>
    </message>
    <message>
        <source>is a database of another program</source>
        <translation>是其他程序的数据库</translation>
    </message>
    <message>
        <source>is a folder, not a database</source>
        <translation>是文件夹，不是数据库</translation>
    </message>
    <message>
        <source>is enrolled in this cohort already</source>
        <translation>已在该批次中登记</translation>
    </message>
    <message>
        <source>is given in &quot;%1&quot;</source>
        <translation>以“%1”为单位</translation>
    </message>
    <message>
        <source>is in this group already</source>
        <translation>已在该组</translation>
    </message>
    <message>
        <source>is measured by nothing</source>
        <translation>没有对应的测量</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>is neither on the virtual nor on the real arm</source>
        <translation>既非虚拟也非实物</translation>
    </message>
    <message>
        <source>is neither practice nor graded</source>
        <translation>既非练习也非计分</translation>
    </message>
    <message>
        <source>is no JSON: %1</source>
        <translation>不是 JSON：%1</translation>
    </message>
    <message>
        <source>is not a database, or is damaged</source>
        <translation>不是数据库，或已损坏</translation>
    </message>
    <message>
        <source>is not known</source>
        <translation>无法识别</translation>
    </message>
    <message>
        <source>is not known here</source>
        <translation>此处无法识别</translation>
    </message>
    <message>
        <source>is not valid JSON (%1)</source>
        <translation>不是有效的 JSON（%1）</translation>
    </message>
    <message>
        <source>is open in another program</source>
        <translation>已在其他程序中打开</translation>
    </message>
    <message>
        <source>it does not begin with %1</source>
        <translation>开头不是 %1</translation>
    </message>
    <message>
        <source>it is not UTF-8 text</source>
        <translation>不是 UTF-8 文本</translation>
    </message>
    <message>
        <source>it is not known which text was shown</source>
        <translation>不清楚显示了哪份文本</translation>
    </message>
    <message>
        <source>it is not said which text was shown</source>
        <translation>未说明显示了哪份文本</translation>
    </message>
    <message>
        <source>it lacks %1, which Torsio can do without</source>
        <translation>缺少 %1，但 Torsio 可不使用</translation>
    </message>
    <message>
        <source>known as a rater; becomes a trainee too</source>
        <translation>已知为评分者；将同时成为学员</translation>
    </message>
    <message>
        <source>known as a trainee; becomes a rater too</source>
        <translation>已知为学员；将同时成为评分者</translation>
    </message>
    <message>
        <source>knows the steps, hesitates, corrects the grasp several times</source>
        <translation>知道步骤，但犹豫，多次调整夹持</translation>
    </message>
    <message>
        <source>lattice mode &apos;%1&apos;</source>
        <translation>网格线模式“%1”</translation>
    </message>
    <message>
        <source>login</source>
        <translation>登录</translation>
    </message>
    <message>
        <source>maximum force</source>
        <translation>最大力</translation>
    </message>
    <message>
        <source>misses the target angle widely, or strains the tissue</source>
        <translation>远离目标角度，或使组织过度受力</translation>
    </message>
    <message>
        <source>model %1</source>
        <translation>模型 %1</translation>
    </message>
    <message>
        <source>models</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>module &quot;%1&quot;</source>
        <translation>模块“%1”</translation>
    </message>
    <message>
        <source>module %1</source>
        <translation>模块 %1</translation>
    </message>
    <message>
        <source>modules %1</source>
        <translation>模块 %1</translation>
    </message>
    <message>
        <source>more than %1 models cannot be compared</source>
        <translation>最多只能比较 %1 个模型</translation>
    </message>
    <message>
        <source>mostly on target, little overshoot, force within limits</source>
        <translation>大多达到目标，超调小，力在限值内</translation>
    </message>
    <message>
        <source>must be a list</source>
        <translation>必须为列表</translation>
    </message>
    <message>
        <source>must be a list in brackets</source>
        <translation>必须为方括号内的列表</translation>
    </message>
    <message>
        <source>must be a text</source>
        <translation>必须为文本</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>必须为整数</translation>
    </message>
    <message>
        <source>must be an object in braces</source>
        <translation>必须为花括号内的对象</translation>
    </message>
    <message>
        <source>must be three numbers in brackets</source>
        <translation>必须为方括号内的三个数</translation>
    </message>
    <message>
        <source>name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>names a module of the simulator, but happens on the real arm</source>
        <translation>指定了模拟器模块，但在实物手臂上进行</translation>
    </message>
    <message>
        <source>needs either a mark or a reason why there is none</source>
        <translation>需要填写评分，或说明无法评分的理由</translation>
    </message>
    <message>
        <source>neither a trainee nor a rater</source>
        <translation>既非学员也非评分者</translation>
    </message>
    <message>
        <source>neither text nor long enough to be binary</source>
        <translation>既不是文本，作为二进制又过短</translation>
    </message>
    <message>
        <source>no allocation design is locked</source>
        <translation>没有已锁定的分组方案</translation>
    </message>
    <message>
        <source>no attempt is left for this module</source>
        <translation>该模块的尝试次数已用完</translation>
    </message>
    <message>
        <source>no column is chosen for %1</source>
        <translation>未为 %1 选择列</translation>
    </message>
    <message>
        <source>no database was named</source>
        <translation>未指定数据库</translation>
    </message>
    <message>
        <source>no evaluation campaign has this id</source>
        <translation>没有此编号的模型评价</translation>
    </message>
    <message>
        <source>no folder &apos;scenes&apos; in it</source>
        <translation>其中没有文件夹“scenes”</translation>
    </message>
    <message>
        <source>no folder for the check can be made</source>
        <translation>无法创建用于检查的文件夹</translation>
    </message>
    <message>
        <source>no haptic device could be opened: %1</source>
        <translation>无法打开力反馈设备：%1</translation>
    </message>
    <message>
        <source>no line of its first 64 kB begins with &quot;v&quot;</source>
        <translation>前 64 kB 内没有以“v”开头的行</translation>
    </message>
    <message>
        <source>no material is called &apos;%1&apos;</source>
        <translation>没有名为“%1”的材料</translation>
    </message>
    <message>
        <source>no scene has a pattern &apos;%1&apos;</source>
        <translation>没有场景含有扭转类型“%1”</translation>
    </message>
    <message>
        <source>no scene is called &apos;%1&apos;</source>
        <translation>没有名为“%1”的场景</translation>
    </message>
    <message>
        <source>no scenes here</source>
        <translation>此处没有场景</translation>
    </message>
    <message>
        <source>no occasion is chosen</source>
        <translation>未选择评分时点</translation>
    </message>
    <message>
        <source>no space left</source>
        <translation>没有剩余空间</translation>
    </message>
    <message>
        <source>no such assignment</source>
        <translation>没有该评分任务</translation>
    </message>
    <message>
        <source>no such database</source>
        <translation>没有该数据库</translation>
    </message>
    <message>
        <source>no such evaluation campaign</source>
        <translation>没有该模型评价</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>没有该文件</translation>
    </message>
    <message>
        <source>no such folder</source>
        <translation>没有该文件夹</translation>
    </message>
    <message>
        <source>no time was spent</source>
        <translation>没有花费时间</translation>
    </message>
    <message>
        <source>no trainee has the code %1</source>
        <translation>没有代码为 %1 的学员</translation>
    </message>
    <message>
        <source>no training time is left</source>
        <translation>没有剩余训练时间</translation>
    </message>
    <message>
        <source>no way leads over the surface from the fixed to the free end</source>
        <translation>从固定端到自由端的曲面不连通</translation>
    </message>
    <message>
        <source>nobody has asked for an adjudicator here</source>
        <translation>此处没有人请求仲裁评分者</translation>
    </message>
    <message>
        <source>nobody is allocated yet</source>
        <translation>尚未有人分组</translation>
    </message>
    <message>
        <source>nobody is asked to score</source>
        <translation>没有邀请任何人评分</translation>
    </message>
    <message>
        <source>nobody is enrolled here under this number</source>
        <translation>此编号未在此登记</translation>
    </message>
    <message>
        <source>nobody is signed in</source>
        <translation>尚未登录</translation>
    </message>
    <message>
        <source>nobody of the demonstration has this role</source>
        <translation>演示中没有人担任此角色</translation>
    </message>
    <message>
        <source>nobody scores in the class %1, which has a weight</source>
        <translation>类别 %1 有权重，但没有人评分</translation>
    </message>
    <message>
        <source>nobody swaps with themselves</source>
        <translation>不能与自己交换</translation>
    </message>
    <message>
        <source>nobody waits for a group</source>
        <translation>没有人等待分组</translation>
    </message>
    <message>
        <source>nobody was chosen</source>
        <translation>未选择任何人</translation>
    </message>
    <message>
        <source>not a PostgreSQL address</source>
        <translation>不是 PostgreSQL 地址</translation>
    </message>
    <message>
        <source>not enough memory to protect the password</source>
        <translation>内存不足，无法保护密码</translation>
    </message>
    <message>
        <source>not everybody has submitted this case yet</source>
        <translation>该案例尚未全部提交</translation>
    </message>
    <message>
        <source>not reported</source>
        <translation>未报告</translation>
    </message>
    <message>
        <source>not reported in a form that makes sense, so a cautious value is assumed: %1</source>
        <translation>未以合理形式报告，因此采用保守值：%1</translation>
    </message>
    <message>
        <source>not tested: the stylus stayed in the inkwell</source>
        <translation>未测试：手写笔一直在笔座中</translation>
    </message>
    <message>
        <source>nothing of the organ lies beyond the cut at its %1 end</source>
        <translation>在%1端切割面之外没有器官部分</translation>
    </message>
    <message>
        <source>number of the step or of compatible_from cannot be read</source>
        <translation>无法读取步骤编号或 compatible_from</translation>
    </message>
    <message>
        <source>occasion</source>
        <translation>评分时点</translation>
    </message>
    <message>
        <source>on target every time, held steadily, gentle throughout</source>
        <translation>每次都达到目标，保持稳定，始终轻柔</translation>
    </message>
    <message>
        <source>one end of the organ is given without the other</source>
        <translation>只给出了器官的一端</translation>
    </message>
    <message>
        <source>only %1 % of the recording has been played</source>
        <translation>仅播放了录制的 %1 %</translation>
    </message>
    <message>
        <source>organs and scenes are not installed</source>
        <translation>未安装器官和场景</translation>
    </message>
    <message>
        <source>passivity controller</source>
        <translation>无源性控制器</translation>
    </message>
    <message>
        <source>password</source>
        <translation>密码</translation>
    </message>
    <message>
        <source>people cannot be balanced by &quot;%1&quot;</source>
        <translation>无法按“%1”均衡人员</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>阶段</translation>
    </message>
    <message>
        <source>platform %1</source>
        <translation>平台 %1</translation>
    </message>
    <message>
        <source>position and joint angles differ by %1 mm from what is published for a Touch</source>
        <translation>位置与关节角相差 %1 mm（与 Touch 公布值相比）</translation>
    </message>
    <message>
        <source>practice must be finite and not negative</source>
        <translation>练习量必须为有限的非负数</translation>
    </message>
    <message>
        <source>practises &quot;%1&quot;, which is no module of this curriculum</source>
        <translation>练习“%1”，但该课程没有此模块</translation>
    </message>
    <message>
        <source>prerequisites run in a circle</source>
        <translation>先修关系形成循环</translation>
    </message>
    <message>
        <source>rater %1, model %2, index %3</source>
        <translation>评分者 %1，模型 %2，指标 %3</translation>
    </message>
    <message>
        <source>raters</source>
        <translation>评分者</translation>
    </message>
    <message>
        <source>reaches the target now and then, overshoots, uses too much force</source>
        <translation>偶尔达到目标，有超调，用力过大</translation>
    </message>
    <message>
        <source>real arm 0-20 min</source>
        <translation>实物手臂 0–20 分钟</translation>
    </message>
    <message>
        <source>real arm 20-40 min</source>
        <translation>实物手臂 20–40 分钟</translation>
    </message>
    <message>
        <source>recordings of this station still wait in files (%1)</source>
        <translation>本工作站仍有录制等待入库（%1）</translation>
    </message>
    <message>
        <source>records are kept for one day at least and a hundred years at most</source>
        <translation>记录保存期最短一天，最长一百年</translation>
    </message>
    <message>
        <source>reference %1</source>
        <translation>参考 %1</translation>
    </message>
    <message>
        <source>refers to a record that does not exist, or is still in use</source>
        <translation>引用了不存在的记录，或仍在使用</translation>
    </message>
    <message>
        <source>requires &quot;%1&quot;, which is no module of this curriculum</source>
        <translation>要求先修“%1”，但该课程没有此模块</translation>
    </message>
    <message>
        <source>requires a module that is not in this version</source>
        <translation>要求的先修模块不在此版本中</translation>
    </message>
    <message>
        <source>requires itself</source>
        <translation>要求先修自身</translation>
    </message>
    <message>
        <source>ridges</source>
        <translation>脊线</translation>
    </message>
    <message>
        <source>role</source>
        <translation>角色</translation>
    </message>
    <message>
        <source>row %1 is not answered</source>
        <translation>第 %1 项未作答</translation>
    </message>
    <message>
        <source>rubric</source>
        <translation>评分标准</translation>
    </message>
    <message>
        <source>scene %1</source>
        <translation>场景 %1</translation>
    </message>
    <message>
        <source>scene &apos;%1&apos; has no pattern &apos;%2&apos;</source>
        <translation>场景“%1”没有扭转类型“%2”</translation>
    </message>
    <message>
        <source>schema name is not allowed</source>
        <translation>不允许的模式名</translation>
    </message>
    <message>
        <source>schema step %1 differs from the one that was applied</source>
        <translation>结构步骤 %1 与已应用的不同</translation>
    </message>
    <message>
        <source>mark of %1 steps lies outside %2 .. %3</source>
        <translation>评分 %1 级超出 %2 .. %3</translation>
    </message>
    <message>
        <source>mark of %1 steps lies outside its scale</source>
        <translation>评分 %1 级超出其量表范围</translation>
    </message>
    <message>
        <source>occasion &quot;%1&quot;</source>
        <translation>评分时点“%1”</translation>
    </message>
    <message>
        <source>occasion %1</source>
        <translation>评分时点 %1</translation>
    </message>
    <message>
        <source>occasions</source>
        <translation>评分时点</translation>
    </message>
    <message>
        <source>scripted hand</source>
        <translation>模拟手</translation>
    </message>
    <message>
        <source>sections</source>
        <translation>截面</translation>
    </message>
    <message>
        <source>sex</source>
        <translation>性别</translation>
    </message>
    <message>
        <source>shown, not felt</source>
        <translation>仅显示，无触感</translation>
    </message>
    <message>
        <source>skill must grow from 0 or more to 1 or less</source>
        <translation>技能须从 0 或以上增长到 1 或以下</translation>
    </message>
    <message>
        <source>somebody else has this staff or student number</source>
        <translation>已有其他人使用此工号或学号</translation>
    </message>
    <message>
        <source>somebody else saved this draft meanwhile</source>
        <translation>其他人刚刚保存了此草稿</translation>
    </message>
    <message>
        <source>somebody of the list is no active rater</source>
        <translation>列表中有人不是在册评分者</translation>
    </message>
    <message>
        <source>somebody of the list is not enrolled here</source>
        <translation>列表中有人未在此登记</translation>
    </message>
    <message>
        <source>something was written to this record after it was copied</source>
        <translation>复制之后该记录又被写入</translation>
    </message>
    <message>
        <source>source and target are the same database</source>
        <translation>源与目标是同一数据库</translation>
    </message>
    <message>
        <source>stands twice</source>
        <translation>出现两次</translation>
    </message>
    <message>
        <source>stiffness</source>
        <translation>刚度</translation>
    </message>
    <message>
        <source>stopped before its end</source>
        <translation>未完成即停止</translation>
    </message>
    <message>
        <source>sure grasp, mostly even turns, works without help</source>
        <translation>夹持稳当，扭转大多均匀，无需帮助</translation>
    </message>
    <message>
        <source>takes no time</source>
        <translation>不占用时间</translation>
    </message>
    <message>
        <source>taking a sheet from its rater needs a reason</source>
        <translation>收回评分表须说明理由</translation>
    </message>
    <message>
        <source>taking marks back needs a reason</source>
        <translation>撤回评分须说明理由</translation>
    </message>
    <message>
        <source>text follows the quoted value %1</source>
        <translation>引号值 %1 之后还有文字</translation>
    </message>
    <message>
        <source>the %1 &quot;%2&quot; was not known when the design was locked</source>
        <translation>锁定方案时没有%1“%2”</translation>
    </message>
    <message>
        <source>the %1 is not recorded</source>
        <translation>未记录%1</translation>
    </message>
    <message>
        <source>the PIN is shorter than %1 digits</source>
        <translation>PIN 码少于 %1 位数字</translation>
    </message>
    <message>
        <source>the address of the server is not complete</source>
        <translation>服务器地址不完整</translation>
    </message>
    <message>
        <source>the administrator has no sign-in name</source>
        <translation>管理员没有登录名</translation>
    </message>
    <message>
        <source>the answer is empty</source>
        <translation>回答为空</translation>
    </message>
    <message>
        <source>the audit trail does not verify after copying; nothing was kept</source>
        <translation>复制后审计记录未通过校验；未保留任何内容</translation>
    </message>
    <message>
        <source>the axis direction must be a unit vector</source>
        <translation>轴线方向必须为单位向量</translation>
    </message>
    <message>
        <source>the axis of the organ has no length</source>
        <translation>器官轴线没有长度</translation>
    </message>
    <message>
        <source>the backup is not sound, so nothing was restored</source>
        <translation>备份不完好，因此未恢复任何内容</translation>
    </message>
    <message>
        <source>the backup is not there any more</source>
        <translation>备份已不存在</translation>
    </message>
    <message>
        <source>the cap radius %1 m is negative or not finite</source>
        <translation>端盖半径 %1 m 为负或不是有限的数</translation>
    </message>
    <message>
        <source>the centre has no name</source>
        <translation>中心没有名称</translation>
    </message>
    <message>
        <source>the centreline has a kink: it turns by %1 within one radius (%2) of the organ, %3 from the fixed end; at most %4 are allowed</source>
        <translation>中心线有弯折：在距固定端 %3 处，一个器官半径（%2）内转过 %1；最多允许 %4</translation>
    </message>
    <message>
        <source>the class %1 has no weight in this evaluation</source>
        <translation>类别 %1 在此评价中没有权重</translation>
    </message>
    <message>
        <source>the code of a model holds a comma</source>
        <translation>模型代码含有逗号</translation>
    </message>
    <message>
        <source>the cohort follows no curriculum</source>
        <translation>该批次没有采用课程</translation>
    </message>
    <message>
        <source>the cohort has no groups</source>
        <translation>该批次没有组别</translation>
    </message>
    <message>
        <source>the cohort has no name</source>
        <translation>该批次没有名称</translation>
    </message>
    <message>
        <source>the column &quot;%1&quot; is empty</source>
        <translation>列“%1”为空</translation>
    </message>
    <message>
        <source>the column for %1 does not exist</source>
        <translation>为 %1 选择的列不存在</translation>
    </message>
    <message>
        <source>the columns are not separated by commas: %1</source>
        <translation>各列未以逗号分隔：%1</translation>
    </message>
    <message>
        <source>the connection to the device broke off</source>
        <translation>与设备的连接已中断</translation>
    </message>
    <message>
        <source>the connection to the device is set up wrongly</source>
        <translation>与设备的连接设置有误</translation>
    </message>
    <message>
        <source>the consent texts cannot be read: %1</source>
        <translation>无法读取同意书文本：%1</translation>
    </message>
    <message>
        <source>the continuous force must lie above 0 N and not above the maximum</source>
        <translation>持续力须大于 0 N 且不超过最大力</translation>
    </message>
    <message>
        <source>the curriculum has no arm for this group</source>
        <translation>课程中没有该组别</translation>
    </message>
    <message>
        <source>the curriculum has no name</source>
        <translation>课程没有名称</translation>
    </message>
    <message>
        <source>the data set has no name</source>
        <translation>数据集没有名称</translation>
    </message>
    <message>
        <source>the database does not answer</source>
        <translation>数据库无响应</translation>
    </message>
    <message>
        <source>the device does not answer</source>
        <translation>设备无响应</translation>
    </message>
    <message>
        <source>the device is calibrated</source>
        <translation>设备已校准</translation>
    </message>
    <message>
        <source>the device is good enough for practice only</source>
        <translation>设备仅适合练习</translation>
    </message>
    <message>
        <source>the device is in use already</source>
        <translation>设备已被占用</translation>
    </message>
    <message>
        <source>the device is not calibrated; its position would be wrong and its force stays off</source>
        <translation>设备未校准；位置会有误差，力输出保持关闭</translation>
    </message>
    <message>
        <source>the device is not ready</source>
        <translation>设备未就绪</translation>
    </message>
    <message>
        <source>the device refused to be calibrated several times</source>
        <translation>设备多次拒绝校准</translation>
    </message>
    <message>
        <source>the device&apos;s force cannot be switched off</source>
        <translation>无法关闭设备的力输出</translation>
    </message>
    <message>
        <source>the device&apos;s force limit was exceeded</source>
        <translation>超过了设备的力限值</translation>
    </message>
    <message>
        <source>the device&apos;s own protection switched the force off</source>
        <translation>设备自身的保护切断了力</translation>
    </message>
    <message>
        <source>the digest of a recording is cut off</source>
        <translation>某条录制的摘要不完整</translation>
    </message>
    <message>
        <source>the direction of ridge 0 is not finite</source>
        <translation>0 号脊线的方向不是有限的数</translation>
    </message>
    <message>
        <source>the docked reference is taken</source>
        <translation>已取得笔座参考</translation>
    </message>
    <message>
        <source>the duration must lie above 0 s and not above a day</source>
        <translation>时长须大于 0 秒且不超过一天</translation>
    </message>
    <message>
        <source>the e-mail address belongs to %1 already, under another number</source>
        <translation>该电子邮件已属于编号不同的 %1</translation>
    </message>
    <message>
        <source>the end caps of the organ touch</source>
        <translation>器官的端盖相接触</translation>
    </message>
    <message>
        <source>the end planes of the axis lie outside the organ or coincide</source>
        <translation>轴线端面在器官之外或重合</translation>
    </message>
    <message>
        <source>the entry itself was changed</source>
        <translation>该条目本身被更改</translation>
    </message>
    <message>
        <source>the evaluation</source>
        <translation>评价</translation>
    </message>
    <message>
        <source>the evaluation has no name</source>
        <translation>该评价没有名称</translation>
    </message>
    <message>
        <source>the file cannot be copied</source>
        <translation>文件无法复制</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>文件无法读取</translation>
    </message>
    <message>
        <source>the file unit must lie between 1e-9 and 1000 m</source>
        <translation>文件单位须在 1e-9 与 1000 m 之间</translation>
    </message>
    <message>
        <source>the force changed faster than the device allows</source>
        <translation>力的变化快于设备允许</translation>
    </message>
    <message>
        <source>the force output did not switch on</source>
        <translation>力输出未能开启</translation>
    </message>
    <message>
        <source>the grasp point must not lie on the axis</source>
        <translation>夹持点不得位于轴线上</translation>
    </message>
    <message>
        <source>the handedness is not known to the record</source>
        <translation>惯用手无法识别</translation>
    </message>
    <message>
        <source>the harmonic field of the organ has no solution</source>
        <translation>器官的调和场无解</translation>
    </message>
    <message>
        <source>the header has no column %1</source>
        <translation>标题行没有列 %1</translation>
    </message>
    <message>
        <source>the header names the column %1 twice</source>
        <translation>标题行中列 %1 出现两次</translation>
    </message>
    <message>
        <source>the id &apos;%1&apos; is used twice</source>
        <translation>编号“%1”被使用两次</translation>
    </message>
    <message>
        <source>the instrument names no mesh &apos;%1&apos;</source>
        <translation>器械没有名为“%1”的网格</translation>
    </message>
    <message>
        <source>the interval</source>
        <translation>区间</translation>
    </message>
    <message>
        <source>the library did not take the servo&apos;s task</source>
        <translation>程序库未接受伺服任务</translation>
    </message>
    <message>
        <source>the library has no valid licence</source>
        <translation>程序库没有有效许可证</translation>
    </message>
    <message>
        <source>the library refused a call</source>
        <translation>程序库拒绝了一次调用</translation>
    </message>
    <message>
        <source>the library refused a force</source>
        <translation>程序库拒绝了一次力输出</translation>
    </message>
    <message>
        <source>the library works on this computer</source>
        <translation>程序库可在本机运行</translation>
    </message>
    <message>
        <source>the library&apos;s servo loop accepts no further task</source>
        <translation>程序库的伺服循环不再接受任务</translation>
    </message>
    <message>
        <source>the library&apos;s servo loop never called</source>
        <translation>程序库的伺服循环从未调用</translation>
    </message>
    <message>
        <source>the library&apos;s servo timer does not work</source>
        <translation>程序库的伺服定时器不工作</translation>
    </message>
    <message>
        <source>the line &quot;%1...&quot; is missing</source>
        <translation>缺少以“%1...”开头的行</translation>
    </message>
    <message>
        <source>the magic is missing</source>
        <translation>缺少文件标识</translation>
    </message>
    <message>
        <source>the manifest cannot be read: %1</source>
        <translation>无法读取清单：%1</translation>
    </message>
    <message>
        <source>the marks of this recording are not released yet</source>
        <translation>此录制的评分尚未公布</translation>
    </message>
    <message>
        <source>the maximum force must be above 0 N</source>
        <translation>最大力必须大于 0 N</translation>
    </message>
    <message>
        <source>the mesh has no triangles</source>
        <translation>网格没有三角形</translation>
    </message>
    <message>
        <source>the method &quot;%1&quot; is not known</source>
        <translation>方法“%1”无法识别</translation>
    </message>
    <message>
        <source>the moment lies outside the recording</source>
        <translation>该时刻超出录制范围</translation>
    </message>
    <message>
        <source>the motors are warm</source>
        <translation>电机过热</translation>
    </message>
    <message>
        <source>the name is missing</source>
        <translation>缺少姓名</translation>
    </message>
    <message>
        <source>the new password is the old one</source>
        <translation>新密码与旧密码相同</translation>
    </message>
    <message>
        <source>the number %1 stands on line %2 already</source>
        <translation>编号 %1 已在第 %2 行出现</translation>
    </message>
    <message>
        <source>the occasion has no name</source>
        <translation>评分时点没有名称</translation>
    </message>
    <message>
        <source>the organ has no longest direction: its two largest extents are as %1 to 1, at least 1.2 is needed</source>
        <translation>器官没有最长方向：两个最大尺寸之比为 %1 比 1，至少需要 1.2</translation>
    </message>
    <message>
        <source>the organ here is not the one of the recording</source>
        <translation>此处的器官与录制中的不同</translation>
    </message>
    <message>
        <source>the organ or its parameters are not those of the recording</source>
        <translation>器官或其参数与录制中的不同</translation>
    </message>
    <message>
        <source>the outline of the section crosses itself</source>
        <translation>截面轮廓自相交</translation>
    </message>
    <message>
        <source>the package cannot be given its name: %1</source>
        <translation>无法为文件包命名：%1</translation>
    </message>
    <message>
        <source>the panel&apos;s mark lies outside the scale of the rubric</source>
        <translation>专家组的评分超出评分标准的范围</translation>
    </message>
    <message>
        <source>the parts of the recording are out of order</source>
        <translation>录制各部分的顺序不正确</translation>
    </message>
    <message>
        <source>the password is a simple pattern</source>
        <translation>密码过于简单</translation>
    </message>
    <message>
        <source>the password is little more than the login name</source>
        <translation>密码与登录名过于相近</translation>
    </message>
    <message>
        <source>the password is shorter than %1 characters</source>
        <translation>密码短于 %1 个字符</translation>
    </message>
    <message>
        <source>the password is too long</source>
        <translation>密码过长</translation>
    </message>
    <message>
        <source>the phase is %1, the time is %2</source>
        <translation>阶段为 %1，时间为 %2</translation>
    </message>
    <message>
        <source>the physicians&apos; marks were shown already</source>
        <translation>已显示过医师的评分</translation>
    </message>
    <message>
        <source>the place of the direction of ridge 0 is %1 of the length, it must lie in 0..1</source>
        <translation>0 号脊线方向的位置为长度的 %1，须在 0..1 之间</translation>
    </message>
    <message>
        <source>the present password is not right</source>
        <translation>当前密码不正确</translation>
    </message>
    <message>
        <source>the queue</source>
        <translation>待评列表</translation>
    </message>
    <message>
        <source>the record</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>the record has changed since the preview</source>
        <translation>预览之后记录已有变化</translation>
    </message>
    <message>
        <source>the recorded strata cannot be read: %1</source>
        <translation>无法读取记录的分层：%1</translation>
    </message>
    <message>
        <source>the recording cannot be opened</source>
        <translation>无法打开录制</translation>
    </message>
    <message>
        <source>the recording is empty</source>
        <translation>录制为空</translation>
    </message>
    <message>
        <source>the recording is not what was recorded</source>
        <translation>录制与当时录制的不一致</translation>
    </message>
    <message>
        <source>the recording was played at a speed that is not allowed</source>
        <translation>录制以不允许的速度播放</translation>
    </message>
    <message>
        <source>the records do not follow from the sealed seed</source>
        <translation>记录与封存的种子不符</translation>
    </message>
    <message>
        <source>the reply is empty</source>
        <translation>回复为空</translation>
    </message>
    <message>
        <source>the report cannot be written</source>
        <translation>无法写入报告</translation>
    </message>
    <message>
        <source>the resting stylus wanders by %1 degrees</source>
        <translation>静置的手写笔漂移 %1 度</translation>
    </message>
    <message>
        <source>the roster has a header but nobody in it</source>
        <translation>名册只有标题行，没有人员</translation>
    </message>
    <message>
        <source>the roster is empty</source>
        <translation>名册为空</translation>
    </message>
    <message>
        <source>the rubric has no name</source>
        <translation>评分标准没有名称</translation>
    </message>
    <message>
        <source>the rubric has no row %1</source>
        <translation>评分标准没有 %1 项</translation>
    </message>
    <message>
        <source>the rubric has no rows</source>
        <translation>评分标准没有评分项</translation>
    </message>
    <message>
        <source>the mark lies outside the scale</source>
        <translation>评分超出量表范围</translation>
    </message>
    <message>
        <source>the sealed seed cannot be read</source>
        <translation>无法读取封存的种子</translation>
    </message>
    <message>
        <source>the section cuts the organ in %1 loops, exactly one is needed</source>
        <translation>截面将器官切出 %1 个环，应恰好为一个</translation>
    </message>
    <message>
        <source>the section does not meet the organ</source>
        <translation>截面与器官不相交</translation>
    </message>
    <message>
        <source>the section encloses no area</source>
        <translation>截面没有围成面积</translation>
    </message>
    <message>
        <source>the server does not let this station in without the typed password</source>
        <translation>不输入密码时服务器不允许本工作站访问</translation>
    </message>
    <message>
        <source>the servo loop did not start</source>
        <translation>伺服循环未启动</translation>
    </message>
    <message>
        <source>the sex is not known to the record</source>
        <translation>性别无法识别</translation>
    </message>
    <message>
        <source>the sheet has no such row</source>
        <translation>评分表没有该行</translation>
    </message>
    <message>
        <source>the sheet was submitted already</source>
        <translation>评分表已提交</translation>
    </message>
    <message>
        <source>the sheet was withdrawn</source>
        <translation>评分表已撤回</translation>
    </message>
    <message>
        <source>the sheet was withdrawn already</source>
        <translation>评分表已被撤回</translation>
    </message>
    <message>
        <source>the shortening must lie between 1 and 600</source>
        <translation>缩短倍数须在 1 与 600 之间</translation>
    </message>
    <message>
        <source>the station %1 is connected</source>
        <translation>工作站“%1”已连接</translation>
    </message>
    <message>
        <source>the stored design cannot be read: %1</source>
        <translation>无法读取存储的方案：%1</translation>
    </message>
    <message>
        <source>the stored model parameters cannot be read</source>
        <translation>无法读取存储的模型参数</translation>
    </message>
    <message>
        <source>the stylus moved faster than the device allows</source>
        <translation>手写笔移动快于设备允许</translation>
    </message>
    <message>
        <source>the surface has %1 triangles, more than a tick can look at</source>
        <translation>曲面有 %1 个三角形，超出单个周期的处理能力</translation>
    </message>
    <message>
        <source>the table has a header but no rows</source>
        <translation>表格只有标题行，没有数据</translation>
    </message>
    <message>
        <source>the table is empty</source>
        <translation>表格为空</translation>
    </message>
    <message>
        <source>the target is not empty: it has rows in the table %1</source>
        <translation>目标不为空：表 %1 中有数据</translation>
    </message>
    <message>
        <source>the task must be finite</source>
        <translation>任务必须为有限的数</translation>
    </message>
    <message>
        <source>the text is not UTF-8</source>
        <translation>文本不是 UTF-8 编码</translation>
    </message>
    <message>
        <source>the tick period must be above 0 us</source>
        <translation>周期必须大于 0 us</translation>
    </message>
    <message>
        <source>the time of the measurement</source>
        <translation>测量时间</translation>
    </message>
    <message>
        <source>the time to watch</source>
        <translation>观察时间</translation>
    </message>
    <message>
        <source>the tremor must lie between 8 and 12 Hz</source>
        <translation>震颤须在 8 与 12 Hz 之间</translation>
    </message>
    <message>
        <source>the turn of the resting stylus wanders by %1 degrees</source>
        <translation>静置手写笔的转角漂移 %1 度</translation>
    </message>
    <message>
        <source>the turn of the stylus has no reference yet</source>
        <translation>手写笔的转角尚无参考</translation>
    </message>
    <message>
        <source>the two databases have different schemas</source>
        <translation>两个数据库的结构不同</translation>
    </message>
    <message>
        <source>the two ends of the organ are not connected or coincide</source>
        <translation>器官两端不连通或重合</translation>
    </message>
    <message>
        <source>the value is too long</source>
        <translation>该值过长</translation>
    </message>
    <message>
        <source>the vendor&apos;s library %1 is loaded</source>
        <translation>厂商程序库 %1 已加载</translation>
    </message>
    <message>
        <source>the vendor&apos;s library %1 is there, but it needs %2, which is missing</source>
        <translation>厂商程序库 %1 存在，但缺少所需的 %2</translation>
    </message>
    <message>
        <source>the vendor&apos;s library %1 is there, but the system refused to load it: %2</source>
        <translation>厂商程序库 %1 存在，但系统拒绝加载：%2</translation>
    </message>
    <message>
        <source>the vendor&apos;s library does not let go of the device</source>
        <translation>厂商程序库未释放设备</translation>
    </message>
    <message>
        <source>the vendor&apos;s library is not installed; looked for %1</source>
        <translation>未安装厂商程序库；已查找 %1</translation>
    </message>
    <message>
        <source>the wait for the calibration</source>
        <translation>等待校准的时间</translation>
    </message>
    <message>
        <source>the warning must come before the lock</source>
        <translation>提醒必须早于锁定</translation>
    </message>
    <message>
        <source>the workspace box must have an inside</source>
        <translation>工作空间必须有内部</translation>
    </message>
    <message>
        <source>there are no demonstration physicians</source>
        <translation>没有演示医师</translation>
    </message>
    <message>
        <source>there are no simulated trainees</source>
        <translation>没有模拟学员</translation>
    </message>
    <message>
        <source>there is no display</source>
        <translation>没有显示器</translation>
    </message>
    <message>
        <source>there is no folder for the pictures</source>
        <translation>没有存放图片的文件夹</translation>
    </message>
    <message>
        <source>there is no record in this database</source>
        <translation>该数据库中没有记录</translation>
    </message>
    <message>
        <source>there is no rubric</source>
        <translation>没有评分标准</translation>
    </message>
    <message>
        <source>there is no such answer</source>
        <translation>没有这条答复</translation>
    </message>
    <message>
        <source>there is no such category of records</source>
        <translation>没有该类记录</translation>
    </message>
    <message>
        <source>there is no such class of raters</source>
        <translation>没有该评分者类别</translation>
    </message>
    <message>
        <source>there is no such cohort</source>
        <translation>没有该批次</translation>
    </message>
    <message>
        <source>there is no such complete recording</source>
        <translation>没有该完整录制</translation>
    </message>
    <message>
        <source>there is no such curriculum</source>
        <translation>没有该课程</translation>
    </message>
    <message>
        <source>there is no such data set</source>
        <translation>没有该数据集</translation>
    </message>
    <message>
        <source>there is no such design</source>
        <translation>没有该方案</translation>
    </message>
    <message>
        <source>there is no such evaluation</source>
        <translation>没有该模型评价</translation>
    </message>
    <message>
        <source>there is no such frozen data set</source>
        <translation>没有该冻结数据集</translation>
    </message>
    <message>
        <source>there is no such group</source>
        <translation>没有该组别</translation>
    </message>
    <message>
        <source>there is no such model</source>
        <translation>没有该模型</translation>
    </message>
    <message>
        <source>there is no such person</source>
        <translation>没有该人员</translation>
    </message>
    <message>
        <source>there is no such person, or they were erased already</source>
        <translation>没有该人员，或已被删除</translation>
    </message>
    <message>
        <source>there is no such purpose</source>
        <translation>没有该用途</translation>
    </message>
    <message>
        <source>there is no such question</source>
        <translation>没有该提问</translation>
    </message>
    <message>
        <source>there is no such recording</source>
        <translation>没有该录制</translation>
    </message>
    <message>
        <source>there is no such reference run</source>
        <translation>没有该参考操作</translation>
    </message>
    <message>
        <source>there is no such remark</source>
        <translation>没有该评语</translation>
    </message>
    <message>
        <source>there is no such rubric</source>
        <translation>没有该评分标准</translation>
    </message>
    <message>
        <source>there is no such occasion</source>
        <translation>没有该评分时点</translation>
    </message>
    <message>
        <source>there is no such sheet</source>
        <translation>没有该评分表</translation>
    </message>
    <message>
        <source>there is no such user</source>
        <translation>没有该用户</translation>
    </message>
    <message>
        <source>there is no such version</source>
        <translation>没有该版本</translation>
    </message>
    <message>
        <source>there is nobody to score</source>
        <translation>没有可评分的对象</translation>
    </message>
    <message>
        <source>there is not enough room for a safety backup and the restored record: %1 MiB are needed, %2 MiB are free</source>
        <translation>空间不足以容纳安全备份和恢复的记录：需要 %1 MiB，可用 %2 MiB</translation>
    </message>
    <message>
        <source>there is nothing to compare</source>
        <translation>没有可比较的内容</translation>
    </message>
    <message>
        <source>these marks are not released</source>
        <translation>这些评分未公布</translation>
    </message>
    <message>
        <source>these marks are released already</source>
        <translation>这些评分已公布</translation>
    </message>
    <message>
        <source>these marks were submitted already</source>
        <translation>这些评分已提交</translation>
    </message>
    <message>
        <source>these minutes make no sense</source>
        <translation>分钟数不合理</translation>
    </message>
    <message>
        <source>this belongs to somebody else</source>
        <translation>这属于其他人</translation>
    </message>
    <message>
        <source>this case has no recording to score</source>
        <translation>该案例没有可评分的录制</translation>
    </message>
    <message>
        <source>this case is not yours</source>
        <translation>该案例不属于您</translation>
    </message>
    <message>
        <source>this case is scored live and has no recording</source>
        <translation>该案例为现场评分，没有录制</translation>
    </message>
    <message>
        <source>this case was taken back</source>
        <translation>该案例已被收回</translation>
    </message>
    <message>
        <source>this database belongs to a centre already</source>
        <translation>该数据库已属于一个中心</translation>
    </message>
    <message>
        <source>this day has passed</source>
        <translation>该日期已过</translation>
    </message>
    <message>
        <source>this display cannot draw the scene</source>
        <translation>此显示设备无法绘制场景</translation>
    </message>
    <message>
        <source>this display cannot draw the scene: it has no OpenGL</source>
        <translation>此显示设备无法绘制场景：没有 OpenGL</translation>
    </message>
    <message>
        <source>this folder exists already</source>
        <translation>该文件夹已存在</translation>
    </message>
    <message>
        <source>this is no active rater</source>
        <translation>不是在册评分者</translation>
    </message>
    <message>
        <source>this is no active trainee</source>
        <translation>不是在册学员</translation>
    </message>
    <message>
        <source>an identity is erased with its retention, not by hand</source>
        <translation>身份信息随保存期限删除，不可手工删除</translation>
    </message>
    <message>
        <source>this is no name of a setting</source>
        <translation>没有该设置名称</translation>
    </message>
    <message>
        <source>this is the last administrator who can sign in</source>
        <translation>这是最后一位可登录的管理员</translation>
    </message>
    <message>
        <source>this kind of deviation is not known</source>
        <translation>无法识别该类方案偏离</translation>
    </message>
    <message>
        <source>this module is locked: first master %1</source>
        <translation>该模块已锁定：请先掌握“%1”</translation>
    </message>
    <message>
        <source>this needs a reason</source>
        <translation>须说明理由</translation>
    </message>
    <message>
        <source>this person has left; the import does not bring them back</source>
        <translation>此人已离开；导入不会将其恢复</translation>
    </message>
    <message>
        <source>this phase belongs to another arm</source>
        <translation>该阶段属于另一组别</translation>
    </message>
    <message>
        <source>this physician cannot be asked</source>
        <translation>无法向该医师提问</translation>
    </message>
    <message>
        <source>this question was put to somebody else</source>
        <translation>该提问是向其他人提出的</translation>
    </message>
    <message>
        <source>this rater cannot be asked about this case</source>
        <translation>无法就此案例邀请该评分者</translation>
    </message>
    <message>
        <source>this record exists already</source>
        <translation>该记录已存在</translation>
    </message>
    <message>
        <source>this record is not due; nothing was erased</source>
        <translation>该记录未到期；未删除任何内容</translation>
    </message>
    <message>
        <source>this record is sealed and cannot be changed</source>
        <translation>该记录已封存，不能更改</translation>
    </message>
    <message>
        <source>this record lies on a database server, which restores its own backups</source>
        <translation>该记录位于数据库服务器上，须由服务器恢复其备份</translation>
    </message>
    <message>
        <source>this recording belongs to somebody else</source>
        <translation>该录制属于其他人</translation>
    </message>
    <message>
        <source>this run is or may be judged without names</source>
        <translation>该操作正在或可能接受匿名评判</translation>
    </message>
    <message>
        <source>this scale has no such mark</source>
        <translation>量表没有该评分</translation>
    </message>
    <message>
        <source>this sheet is not submitted yet</source>
        <translation>该评分表尚未提交</translation>
    </message>
    <message>
        <source>this sheet was changed at another station meanwhile</source>
        <translation>该评分表刚刚在另一工作站被更改</translation>
    </message>
    <message>
        <source>this trainee is not in the cohort</source>
        <translation>该学员不在此批次</translation>
    </message>
    <message>
        <source>this version of the curriculum is not running</source>
        <translation>该课程版本未在进行中</translation>
    </message>
    <message>
        <source>tick period %1 us, latency %2 ticks, damping %3 N s/m</source>
        <translation>周期 %1 us，延迟 %2 个周期，阻尼 %3 N s/m</translation>
    </message>
    <message>
        <source>trainee</source>
        <translation>学员</translation>
    </message>
    <message>
        <source>training has begun: the curriculum of this cohort stays</source>
        <translation>训练已开始：该批次的课程不再更换</translation>
    </message>
    <message>
        <source>triangle %1</source>
        <translation>三角形 %1</translation>
    </message>
    <message>
        <source>two anchors stand at the same mark</source>
        <translation>同一评分有两个锚点</translation>
    </message>
    <message>
        <source>two columns are called &quot;%1&quot;</source>
        <translation>有两列都名为“%1”</translation>
    </message>
    <message>
        <source>two groups are called %1</source>
        <translation>有两组都名为 %1</translation>
    </message>
    <message>
        <source>two models have the same code</source>
        <translation>有两个模型代码相同</translation>
    </message>
    <message>
        <source>two ridges cannot bound an area</source>
        <translation>两条脊线无法围成面积</translation>
    </message>
    <message>
        <source>two rows have the same code</source>
        <translation>有两行代码相同</translation>
    </message>
    <message>
        <source>uncertain grasp, jerky turns, needs help at every step</source>
        <translation>夹持不稳，扭转生硬，每一步都需帮助</translation>
    </message>
    <message>
        <source>unknown token in a statement</source>
        <translation>语句中有未知的标记</translation>
    </message>
    <message>
        <source>unknown token {{%1}}</source>
        <translation>未知的标记 {{%1}}</translation>
    </message>
    <message>
        <source>unknown unit &quot;%1&quot;</source>
        <translation>未知的单位“%1”</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>顶点 %1</translation>
    </message>
    <message>
        <source>virtual 0-20 min</source>
        <translation>虚拟 0–20 分钟</translation>
    </message>
    <message>
        <source>virtual 20-40 min</source>
        <translation>虚拟 20–40 分钟</translation>
    </message>
    <message>
        <source>wait for each other: nobody could ever begin them</source>
        <translation>互相等待：任何人都无法开始</translation>
    </message>
    <message>
        <source>warm; the force is folded back</source>
        <translation>过热；力已降低</translation>
    </message>
    <message>
        <source>was not allocated by this design</source>
        <translation>不是由此方案分组</translation>
    </message>
    <message>
        <source>was written by a newer version of Torsio (schema %1, this program knows %2)</source>
        <translation>由更新版本的 Torsio 写入（结构 %1，此程序支持 %2）</translation>
    </message>
    <message>
        <source>withdrawn</source>
        <translation>已退出</translation>
    </message>
    <message>
        <source>you are not asked in this evaluation</source>
        <translation>您未受邀参加此评价</translation>
    </message>
    <message>
        <source>you are not enrolled as a trainee</source>
        <translation>您未登记为学员</translation>
    </message>
    <message>
        <source>you are signed in as %1, who may not do this</source>
        <translation>您以 %1 登录，没有此权限</translation>
    </message>
    <message>
        <source>you came in with the PIN</source>
        <translation>您是用 PIN 码进入的</translation>
    </message>
    <message>
        <source>you have not agreed to be recorded</source>
        <translation>您尚未同意被记录</translation>
    </message>
    <message>
        <source>your curriculum has no such module</source>
        <translation>您的课程没有该模块</translation>
    </message>
    <message>
        <source>female</source>
        <translation>女</translation>
    </message>
    <message>
        <source>male</source>
        <translation>男</translation>
    </message>
    <message>
        <source>other</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>first-year graduate</source>
        <translation>一年级研究生</translation>
    </message>
    <message>
        <source>master&apos;s student</source>
        <translation>硕士研究生</translation>
    </message>
    <message>
        <source>doctoral student</source>
        <translation>博士研究生</translation>
    </message>
    <message>
        <source>level</source>
        <translation>学历</translation>
    </message>
    <message>
        <source>experience</source>
        <translation>经验</translation>
    </message>
    <message>
        <source>complete permutation</source>
        <translation>全体随机排列</translation>
    </message>
    <message>
        <source>permuted blocks</source>
        <translation>置换区组</translation>
    </message>
    <message>
        <source>stratified blocks</source>
        <translation>分层区组</translation>
    </message>
    <message>
        <source>minimisation</source>
        <translation>最小化法</translation>
    </message>
    <message>
        <source>mt19937_64, bounded by rejection, Fisher-Yates from the back</source>
        <translation>mt19937_64，拒绝法取界，自末位的 Fisher-Yates 洗牌</translation>
    </message>
    <message>
        <source>late</source>
        <translation>迟到</translation>
    </message>
    <message>
        <source>absent</source>
        <translation>缺席</translation>
    </message>
    <message>
        <source>device failed</source>
        <translation>设备故障</translation>
    </message>
    <message>
        <source>swapped</source>
        <translation>已互换</translation>
    </message>
    <message>
        <source>phase cut short</source>
        <translation>阶段提前结束</translation>
    </message>
    <message>
        <source>phase too long</source>
        <translation>阶段过长</translation>
    </message>
    <message>
        <source>rest too long</source>
        <translation>休息过长</translation>
    </message>
    <message>
        <source>available-case</source>
        <translation>按可用数据</translation>
    </message>
    <message>
        <source>list-wise</source>
        <translation>成列删除</translation>
    </message>
    <message>
        <source>renormalised</source>
        <translation>重新归一化</translation>
    </message>
    <message>
        <source>few raters</source>
        <translation>评分者过少</translation>
    </message>
    <message>
        <source>Demonstration centre (simulated)</source>
        <translation>演示中心（模拟）</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>论文</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1；%2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>%1 %2 (weight %3)</source>
        <translation>%1 %2（权重 %3）</translation>
    </message>
    <message>
        <source>%1 %2 has changed</source>
        <translation>%1 %2 已改变</translation>
    </message>
    <message>
        <source>%1 %2 is no longer there</source>
        <translation>%1 %2 已不存在</translation>
    </message>
    <message>
        <source>%1 %2 was added</source>
        <translation>%1 %2 为新增</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%1，由 %2 冻结</translation>
    </message>
    <message>
        <source>%1 is in a group that no record tells of</source>
        <translation>%1 所在的组没有任何分组记录</translation>
    </message>
    <message>
        <source>%1 is left out: it has fewer than %2 trainees.</source>
        <translation>%1 未列出：该组学员少于 %2 人。</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>%1, seed %2</source>
        <translation>%1，种子 %2</translation>
    </message>
    <message>
        <source>%1, seed sealed</source>
        <translation>%1，种子已封存</translation>
    </message>
    <message>
        <source>%1, the same in every run</source>
        <translation>%1，每次操作均相同</translation>
    </message>
    <message>
        <source>%1. Method: %2; generator: %3; seed: %4.</source>
        <translation>%1。方法：%2；随机数发生器：%3；种子：%4。</translation>
    </message>
    <message>
        <source>%1: high</source>
        <translation>%1：上限</translation>
    </message>
    <message>
        <source>%1: low</source>
        <translation>%1：下限</translation>
    </message>
    <message>
        <source>1 is perfect agreement; 0 is what marks by chance would give.</source>
        <translation>1 表示完全一致；0 表示与随机评分无异。</translation>
    </message>
    <message>
        <source>A row that is lighter or darker all along is a rater who is stricter or more lenient. An empty cell is a mark that was not given.</source>
        <translation>整行偏浅或偏深，说明该评分者较严或较宽。空格表示未给出评分。</translation>
    </message>
    <message>
        <source>Agreement and comparisons</source>
        <translation>一致性与组间比较</translation>
    </message>
    <message>
        <source>Agreement of the raters at each occasion</source>
        <translation>各评分时点的评分者间一致性</translation>
    </message>
    <message>
        <source>Agreement of the raters with 95 % intervals</source>
        <translation>评分者间一致性及 95 % 置信区间</translation>
    </message>
    <message>
        <source>All people and marks in this report are simulated. No conclusion about training, trainees or models may be drawn from it.</source>
        <translation>本报告中的人员和评分均为模拟，不得据此对训练、学员或模型得出任何结论。</translation>
    </message>
    <message>
        <source>Allocated</source>
        <translation>已分组</translation>
    </message>
    <message>
        <source>Allocation</source>
        <translation>随机分组</translation>
    </message>
    <message>
        <source>Allocation commitment</source>
        <translation>分组承诺值</translation>
    </message>
    <message>
        <source>Angle error by twist, mean of the trainees with 95 % interval</source>
        <translation>各次扭转的角度误差：学员均值及 95 % 置信区间</translation>
    </message>
    <message>
        <source>Bland and Altman against the mean of the others, last occasion</source>
        <translation>末次评分时点，与其余评分者均值的 Bland-Altman 分析</translation>
    </message>
    <message>
        <source>Block sizes</source>
        <translation>区组大小</translation>
    </message>
    <message>
        <source>Boxes end at the quartiles (rule: Hyndman and Fan type 7); whiskers reach the most extreme value within 1.5 interquartile ranges of the box; values beyond are drawn singly; the separate symbol is the mean.</source>
        <translation>箱体两端为四分位数（Hyndman-Fan 第 7 型）；须线延伸至距箱体 1.5 倍四分位距以内的最远值；超出者单独绘出；单独的符号为均值。</translation>
    </message>
    <message>
        <source>By level</source>
        <translation>按学历</translation>
    </message>
    <message>
        <source>By sex</source>
        <translation>按性别</translation>
    </message>
    <message>
        <source>Category</source>
        <translation>类别</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>Changed since the freeze</source>
        <translation>冻结后的改变</translation>
    </message>
    <message>
        <source>Check of the draw</source>
        <translation>抽签核对</translation>
    </message>
    <message>
        <source>Check the data that the report is made from.</source>
        <translation>请检查生成报告所用的数据。</translation>
    </message>
    <message>
        <source>Choose 0.8.</source>
        <translation>请选择 0.8。</translation>
    </message>
    <message>
        <source>Choose permuted blocks, or enrol equal arms.</source>
        <translation>请选择置换区组，或使各组人数相等。</translation>
    </message>
    <message>
        <source>Cohort</source>
        <translation>批次</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Comprehensive score N of each model</source>
        <translation>各模型的综合得分 N</translation>
    </message>
    <message>
        <source>Comprehensive score N: %1.</source>
        <translation>综合得分 N：%1。</translation>
    </message>
    <message>
        <source>Comprehensive score of each rater of the class %1</source>
        <translation>%1类各评分者的综合得分</translation>
    </message>
    <message>
        <source>Comprehensive scores of all raters</source>
        <translation>全体评分者的综合得分</translation>
    </message>
    <message>
        <source>Content hash</source>
        <translation>内容哈希</translation>
    </message>
    <message>
        <source>Corresponds to Fig. 15 of the paper. The symbol in each range is the class-weighted mean M.</source>
        <translation>对应论文图 15。各范围内的符号为类别加权均值 M。</translation>
    </message>
    <message>
        <source>Corresponds to Fig. 16 of the paper.</source>
        <translation>对应论文图 16。</translation>
    </message>
    <message>
        <source>Corresponds to Fig. 17 of the paper. The centre is the class-weighted mean M, not the plain mean, and every rater counts once; the value is the population variance plus the squared distance between the two means.</source>
        <translation>对应论文图 17。以类别加权均值 M 而非算术均值为中心，每名评分者计一次；其值等于总体方差加上两均值之差的平方。</translation>
    </message>
    <message>
        <source>Corresponds to Fig. 18 of the paper: %1 only, one point a rater and model.</source>
        <translation>对应论文图 18：仅含%1，每名评分者、每个模型一个点。</translation>
    </message>
    <message>
        <source>Corresponds to Fig. 19 of the paper. Eq. 27 gives one number for each model; what is drawn is the distribution of the scores that Eq. 27 gives for each single rater.</source>
        <translation>对应论文图 19。式 (27) 对每个模型给出一个数；图中为按式 (27) 逐一计算的各评分者得分的分布。</translation>
    </message>
    <message>
        <source>Corresponds to Fig. 23 of the paper, which does not define its variance. Drawn is the variance of the trainee scores of a group about their mean, divisor n; the table gives two other readings.</source>
        <translation>对应论文图 23，论文未定义其方差。图中为组内学员得分围绕组均值的方差，除数为 n；表中另列两种算法。</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>数量</translation>
    </message>
    <message>
        <source>Course of every trainee, %1 (%2)</source>
        <translation>各学员的得分变化，%1（%2）</translation>
    </message>
    <message>
        <source>Course of the groups over the occasions</source>
        <translation>各组随评分时点的变化</translation>
    </message>
    <message>
        <source>DEMONSTRATION DATA - SIMULATED</source>
        <translation>演示数据（模拟）</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>Degrees of freedom</source>
        <translation>自由度</translation>
    </message>
    <message>
        <source>Demonstration data: nothing in it is a result.</source>
        <translation>演示数据：其中任何内容都不是研究结果。</translation>
    </message>
    <message>
        <source>Demonstration with simulated people and marks</source>
        <translation>使用模拟人员与评分的演示</translation>
    </message>
    <message>
        <source>Demonstration: the people, their movements and all marks in this report are simulated. Nothing in it is a result about real trainees.</source>
        <translation>演示数据：本报告中的人员、动作和全部评分均为模拟，其中任何内容都不是关于真实学员的结果。</translation>
    </message>
    <message>
        <source>Design of the allocation</source>
        <translation>分组方案</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>方案偏离</translation>
    </message>
    <message>
        <source>Deviations from the protocol</source>
        <translation>方案偏离明细</translation>
    </message>
    <message>
        <source>Difference of mean ranks</source>
        <translation>平均秩次之差</translation>
    </message>
    <message>
        <source>Differences between the groups at the end, adjusted for the score before</source>
        <translation>训练结束时的组间差值（按训练前得分校正）</translation>
    </message>
    <message>
        <source>Each mark against the other raters, last occasion</source>
        <translation>末次评分时点：各评分与其余评分者的比较</translation>
    </message>
    <message>
        <source>Each rater scored every model on %1 indices from %2 to %3 points. Raters: %4.</source>
        <translation>每名评分者按 %1 项指标对各模型评分，每项 %2 至 %3 分。评分者：%4。</translation>
    </message>
    <message>
        <source>Each simulated mark is the whole point nearest to baseline + gain of the group + talent of the trainee - severity of the rater + chance, held on the scale. Baseline %1; gains after 20 and 40 minutes: %2; talent, severity and chance are normal with standard deviations %3, %4 and %5 points; talents are centred within each group and severities over the raters. The gains were chosen to show the pattern that the paper describes in words; they are not estimates, and no conclusion about training may be drawn from them.</source>
        <translation>每个模拟评分为下式取最近整数并限于量表之内：基线 + 组的提高值 + 学员天赋 - 评分者严格度 + 随机项。基线 %1；20 分钟和 40 分钟后的提高值：%2；天赋、严格度和随机项服从正态分布，标准差分别为 %3、%4 和 %5 分；天赋在组内居中，严格度在评分者间居中。提高值按论文的文字描述选定，仅用于显示其趋势；它们不是估计值，不得据此对训练得出任何结论。</translation>
    </message>
    <message>
        <source>Each simulated mark of a model is the whole point nearest to quality of the model on the index + shift of the rater class - severity of the rater + chance, held on the scale. Qualities for the nine indices in order: %1; class shifts -0.3, 0.0 and 0.2; severity and chance are normal with standard deviations %2 and %3 points. The qualities were chosen to give readable charts; they say nothing about any model.</source>
        <translation>每个模型的模拟评分为下式取最近整数并限于量表之内：模型在该指标上的质量 + 评分者类别的偏移 - 评分者严格度 + 随机项。九项指标的质量依次为：%1；类别偏移为 -0.3、0.0 和 0.2；严格度和随机项服从正态分布，标准差分别为 %2 和 %3 分。质量值仅为使图表易读而选定，不说明任何模型的优劣。</translation>
    </message>
    <message>
        <source>Each trainee is fitted alone; eight twists are the fewest for a curve with three parameters.</source>
        <translation>每名学员单独拟合；含三个参数的曲线至少需要八次扭转。</translation>
    </message>
    <message>
        <source>Earlier designs</source>
        <translation>此前的方案</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>效应</translation>
    </message>
    <message>
        <source>Enrol each person once; analyse as allocated.</source>
        <translation>每人只登记一次；按分组结果分析。</translation>
    </message>
    <message>
        <source>Eq. 25</source>
        <translation>式 (25)</translation>
    </message>
    <message>
        <source>Eq. 26</source>
        <translation>式 (26)</translation>
    </message>
    <message>
        <source>Eq. 27</source>
        <translation>式 (27)</translation>
    </message>
    <message>
        <source>Eq. 27 for one rater</source>
        <translation>单个评分者的式 (27)</translation>
    </message>
    <message>
        <source>Eq. 27 for one rater; quantiles of type 7</source>
        <translation>单个评分者的式 (27)；第 7 型分位数</translation>
    </message>
    <message>
        <source>Eqs. 25 and 26</source>
        <translation>式 (25)、(26)</translation>
    </message>
    <message>
        <source>Error left in the end (deg)</source>
        <translation>最终残余误差 (°)</translation>
    </message>
    <message>
        <source>Evaluated models</source>
        <translation>被评价的模型</translation>
    </message>
    <message>
        <source>Evaluation formulas</source>
        <translation>评价公式</translation>
    </message>
    <message>
        <source>Evaluation of models</source>
        <translation>模型评价</translation>
    </message>
    <message>
        <source>Evaluation of the models</source>
        <translation>模型评价</translation>
    </message>
    <message>
        <source>Flags</source>
        <translation>标志</translation>
    </message>
    <message>
        <source>Flow of participants</source>
        <translation>参与者流程</translation>
    </message>
    <message>
        <source>Friedman on the raters&apos; own comprehensive scores</source>
        <translation>对各评分者综合得分的 Friedman 检验</translation>
    </message>
    <message>
        <source>From every trainee&apos;s scores back to marks and recordings</source>
        <translation>由各学员得分追溯到评分与录制</translation>
    </message>
    <message>
        <source>Frozen</source>
        <translation>冻结时间</translation>
    </message>
    <message>
        <source>Frozen data set</source>
        <translation>冻结数据集</translation>
    </message>
    <message>
        <source>Frozen data set, content hash</source>
        <translation>冻结数据集的内容哈希</translation>
    </message>
    <message>
        <source>Gain from before to the end, by ranks</source>
        <translation>训练前至结束的提高值（秩检验）</translation>
    </message>
    <message>
        <source>Generalised eta squared</source>
        <translation>广义 η²</translation>
    </message>
    <message>
        <source>Give en or zh_CN</source>
        <translation>请给出 en 或 zh_CN</translation>
    </message>
    <message>
        <source>Give multiples of the number of arms.</source>
        <translation>请给出组数的整数倍。</translation>
    </message>
    <message>
        <source>Give one or more block sizes.</source>
        <translation>请给出一个或多个区组大小。</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>组别</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>第 %1 组</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>组数</translation>
    </message>
    <message>
        <source>Hash of the source</source>
        <translation>来源的哈希</translation>
    </message>
    <message>
        <source>Hedges g</source>
        <translation>Hedges g</translation>
    </message>
    <message>
        <source>Hedges g [95 %]</source>
        <translation>Hedges g [95 %]</translation>
    </message>
    <message>
        <source>Hedges g, interval from the noncentral t distribution</source>
        <translation>Hedges g，区间由非中心 t 分布得出</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>最高</translation>
    </message>
    <message>
        <source>ICC(2,1) [95 %]</source>
        <translation>ICC(2,1) [95 %]</translation>
    </message>
    <message>
        <source>ICC(2,1), one rater</source>
        <translation>ICC(2,1)，单个评分者</translation>
    </message>
    <message>
        <source>ICC(2,k) [95 %]</source>
        <translation>ICC(2,k) [95 %]</translation>
    </message>
    <message>
        <source>ICC(2,k), mean of all raters</source>
        <translation>ICC(2,k)，全体评分者均值</translation>
    </message>
    <message>
        <source>Index</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Item</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Krippendorff alpha</source>
        <translation>Krippendorff α</translation>
    </message>
    <message>
        <source>Kruskal-Wallis H = %1, %2, epsilon squared %3.</source>
        <translation>Kruskal-Wallis H = %1，%2，ε² = %3。</translation>
    </message>
    <message>
        <source>Kruskal-Wallis, Dunn with Holm, exact Mann-Whitney</source>
        <translation>Kruskal-Wallis 检验，Dunn 检验（Holm 校正），Mann-Whitney 精确检验</translation>
    </message>
    <message>
        <source>LC-CUSUM, Biau and Porcher 2010</source>
        <translation>LC-CUSUM，Biau 与 Porcher 2010</translation>
    </message>
    <message>
        <source>Learning</source>
        <translation>学习过程</translation>
    </message>
    <message>
        <source>Learning of every trainee on the simulator</source>
        <translation>各学员在模拟器上的学习过程</translation>
    </message>
    <message>
        <source>Limits of agreement, last occasion</source>
        <translation>一致性界限（末次评分时点）</translation>
    </message>
    <message>
        <source>List its levels.</source>
        <translation>请列出其水平。</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>已锁定</translation>
    </message>
    <message>
        <source>Lower quartile</source>
        <translation>下四分位数</translation>
    </message>
    <message>
        <source>Lower whisker</source>
        <translation>下须</translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation>最低</translation>
    </message>
    <message>
        <source>Lowest, weighted mean and highest score of each index</source>
        <translation>各指标的最低分、加权均值和最高分</translation>
    </message>
    <message>
        <source>M (Eq. 25)</source>
        <translation>M（式 25）</translation>
    </message>
    <message>
        <source>M (Eq. 25) is the sum over rater classes of the class weight times the class mean. s2 (Eq. 26) is the mean squared distance of all raters&apos; marks from M, with divisor n; it is not the usual variance, because its centre is the weighted mean. N (Eq. 27) is the sum over indices of the index weight times M.</source>
        <translation>M（式 25）为各评分者类别的权重与类别均值乘积之和。s²（式 26）为全体评分者评分与 M 之差的平方的平均，除数为 n；因以加权均值为中心，它不同于通常的方差。N（式 27）为各指标权重与 M 乘积之和。</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>生成时间</translation>
    </message>
    <message>
        <source>Scored %1</source>
        <translation>%1评分</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>评分数</translation>
    </message>
    <message>
        <source>Marks are whole steps of the scale; M, s2 and N are computed in whole numbers and rounded once, so the tables do not depend on the order of the raters.</source>
        <translation>评分为量表的整数级；M、s² 和 N 以整数计算并只舍入一次，因此各表与评分者的先后顺序无关。</translation>
    </message>
    <message>
        <source>Marks behind the scores</source>
        <translation>得分所依据的评分数</translation>
    </message>
    <message>
        <source>Marks by trainee and rater, last occasion</source>
        <translation>末次评分时点各学员、各评分者的评分</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>均值</translation>
    </message>
    <message>
        <source>Mean absolute angle error (deg)</source>
        <translation>平均绝对角度误差 (°)</translation>
    </message>
    <message>
        <source>Mean error, first half (deg)</source>
        <translation>前半程平均误差 (°)</translation>
    </message>
    <message>
        <source>Mean of raters, by class weight</source>
        <translation>评分者均值（按类别加权）</translation>
    </message>
    <message>
        <source>Mean peak force (N)</source>
        <translation>平均峰值力 (N)</translation>
    </message>
    <message>
        <source>Mean peak torque (N m)</source>
        <translation>平均峰值扭矩 (N m)</translation>
    </message>
    <message>
        <source>Mean rank (1 is lowest)</source>
        <translation>平均秩次（1 为最低）</translation>
    </message>
    <message>
        <source>Mean score before</source>
        <translation>训练前平均得分</translation>
    </message>
    <message>
        <source>Mean score by class of raters</source>
        <translation>各类评分者的平均分</translation>
    </message>
    <message>
        <source>Mean score of each group over the study</source>
        <translation>研究期间各组平均得分</translation>
    </message>
    <message>
        <source>Mean variance between raters, divisor n - 1</source>
        <translation>评分者间平均方差（除数 n - 1）</translation>
    </message>
    <message>
        <source>Measured by the simulator, twist by twist, in the order of the recordings. The marks of the physicians are a separate matter.</source>
        <translation>由模拟器按录制顺序逐次扭转测得。医师的评分另行分析。</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>中位数</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Methods and limits</source>
        <translation>方法与局限</translation>
    </message>
    <message>
        <source>Minutes</source>
        <translation>分钟</translation>
    </message>
    <message>
        <source>Minutes recorded</source>
        <translation>记录分钟数</translation>
    </message>
    <message>
        <source>Missing marks: %1.</source>
        <translation>缺失评分：%1。</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Model %1: exact values by index</source>
        <translation>模型 %1：各指标的精确值</translation>
    </message>
    <message>
        <source>Moved by hand, with a reason</source>
        <translation>人工调整（有理由）</translation>
    </message>
    <message>
        <source>N (Eq. 27)</source>
        <translation>N（式 27）</translation>
    </message>
    <message>
        <source>Name a factor with its levels.</source>
        <translation>请指定一个因素及其水平。</translation>
    </message>
    <message>
        <source>Name at least two arms.</source>
        <translation>请至少指定两个组。</translation>
    </message>
    <message>
        <source>No deviation from the protocol was reported.</source>
        <translation>没有报告方案偏离。</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>序号</translation>
    </message>
    <message>
        <source>Offset [95 %], all occasions</source>
        <translation>偏差 [95 %]，全部评分时点</translation>
    </message>
    <message>
        <source>Offsets are taken against the mean of the other raters; a mean that contains the rater would agree by construction.</source>
        <translation>偏差相对于其余评分者的均值计算；若均值包含该评分者本人，必然趋于一致。</translation>
    </message>
    <message>
        <source>On target</source>
        <translation>达标</translation>
    </message>
    <message>
        <source>Order of the models over all raters</source>
        <translation>全体评分者对模型的排序</translation>
    </message>
    <message>
        <source>Organ of the training</source>
        <translation>训练器官</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>须线之外</translation>
    </message>
    <message>
        <source>P(first &gt; second)</source>
        <translation>P(前者 &gt; 后者)</translation>
    </message>
    <message>
        <source>Part of the report</source>
        <translation>报告部分</translation>
    </message>
    <message>
        <source>Participants and allocation</source>
        <translation>参与者与随机分组</translation>
    </message>
    <message>
        <source>Participants by group</source>
        <translation>各组参与者</translation>
    </message>
    <message>
        <source>People allocated</source>
        <translation>已分组人数</translation>
    </message>
    <message>
        <source>People are shown</source>
        <translation>人员显示方式</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>阶段</translation>
    </message>
    <message>
        <source>Plain mean</source>
        <translation>算术均值</translation>
    </message>
    <message>
        <source>Plan a new list; the old one stays as it is.</source>
        <translation>请另建新的分组表；旧表保持不变。</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>方案</translation>
    </message>
    <message>
        <source>Provenance</source>
        <translation>数据来源</translation>
    </message>
    <message>
        <source>Rater</source>
        <translation>评分者</translation>
    </message>
    <message>
        <source>Raters</source>
        <translation>评分者</translation>
    </message>
    <message>
        <source>Raters are shown by code, for the organisers of the study; this is no ranking.</source>
        <translation>评分者以代码显示，供研究组织者参考；并非排名。</translation>
    </message>
    <message>
        <source>Raters beside each other</source>
        <translation>评分者对照</translation>
    </message>
    <message>
        <source>Raters with all marks</source>
        <translation>评分完整的评分者数</translation>
    </message>
    <message>
        <source>Record compared with it</source>
        <translation>当前记录与其比较</translation>
    </message>
    <message>
        <source>Record every factor before allocation.</source>
        <translation>请在分组前记录全部因素。</translation>
    </message>
    <message>
        <source>Rest in all (min)</source>
        <translation>休息合计 (min)</translation>
    </message>
    <message>
        <source>Rest stops the clock of the training phases.</source>
        <translation>休息时训练阶段停止计时。</translation>
    </message>
    <message>
        <source>Rests taken during training: %1.</source>
        <translation>训练期间休息次数：%1。</translation>
    </message>
    <message>
        <source>SE</source>
        <translation>标准误</translation>
    </message>
    <message>
        <source>SE of M</source>
        <translation>M 的标准误</translation>
    </message>
    <message>
        <source>Sample variance</source>
        <translation>样本方差</translation>
    </message>
    <message>
        <source>Scores at the end, adjusted for the score before</source>
        <translation>结束时得分（按训练前得分校正）</translation>
    </message>
    <message>
        <source>Scores of the trainees %1</source>
        <translation>%1各学员的得分</translation>
    </message>
    <message>
        <source>Occasion</source>
        <translation>评分时点</translation>
    </message>
    <message>
        <source>Second half (deg)</source>
        <translation>后半程 (°)</translation>
    </message>
    <message>
        <source>Second organ</source>
        <translation>第二器官</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>系列</translation>
    </message>
    <message>
        <source>Severity of the raters</source>
        <translation>评分者的严格度</translation>
    </message>
    <message>
        <source>Shrout and Fleiss ICC(2,1), ICC(2,k)</source>
        <translation>Shrout-Fleiss 组内相关系数 ICC(2,1)、ICC(2,k)</translation>
    </message>
    <message>
        <source>Shrout and Fleiss ICC(2,1), ICC(2,k); Krippendorff alpha</source>
        <translation>Shrout-Fleiss 组内相关系数 ICC(2,1)、ICC(2,k)；Krippendorff α</translation>
    </message>
    <message>
        <source>Simulated date</source>
        <translation>模拟日期</translation>
    </message>
    <message>
        <source>Since then</source>
        <translation>冻结之后</translation>
    </message>
    <message>
        <source>Single marks are not shown. The role that made this report sees them, under codes, once every rater has submitted and the data set is frozen.</source>
        <translation>不显示单个评分。待全体评分者提交且数据集冻结后，生成本报告的角色才能以代码形式查看。</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>软件</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Standardised differences of the scores at the end</source>
        <translation>结束时得分的标准化差值（效应量）</translation>
    </message>
    <message>
        <source>Strata or margins</source>
        <translation>分层或边际因素</translation>
    </message>
    <message>
        <source>Strictest first. Scores are not corrected for severity: every trainee is scored by the same raters, so that it does not change their order.</source>
        <translation>最严者在前。得分未按严格度校正：每名学员由相同的评分者评分，不影响学员的排序。</translation>
    </message>
    <message>
        <source>Surgical twist skills</source>
        <translation>外科扭转操作技能</translation>
    </message>
    <message>
        <source>Test of equal slopes not defined: %1.</source>
        <translation>斜率相等检验无定义：%1。</translation>
    </message>
    <message>
        <source>The evaluation of the models is left out: a class has fewer than %1 raters.</source>
        <translation>模型评价未列出：有一类评分者少于 %1 人。</translation>
    </message>
    <message>
        <source>The first 16 digits of each content hash; the whole hashes stand in the table of numbers (CSV).</source>
        <translation>各内容哈希的前 16 位；完整哈希见数据表 (CSV)。</translation>
    </message>
    <message>
        <source>The marks are simulated. The tables show what is computed and how it is presented; their values mean nothing.</source>
        <translation>评分为模拟数据。各表仅展示计算内容与呈现方式，数值没有意义。</translation>
    </message>
    <message>
        <source>The sequence has not been repeated from the seed.</source>
        <translation>尚未由种子重现分组序列。</translation>
    </message>
    <message>
        <source>The sequence was repeated from the seed and every arm was found the same.</source>
        <translation>已由种子重现分组序列，各组均一致。</translation>
    </message>
    <message>
        <source>The trainee is the unit of analysis: marks of several raters for one trainee are averaged first.</source>
        <translation>以学员为分析单位：先对同一学员的多个评分取均值。</translation>
    </message>
    <message>
        <source>The trainees&apos; movements come from a scripted hand with a seed; the simulator, the recorder and every computation are the real ones.</source>
        <translation>学员的动作由带种子的脚本手产生；模拟器、记录器和全部计算均为真实程序。</translation>
    </message>
    <message>
        <source>The variance of the training evaluation is not defined in the paper. The figure shows the variance of the trainee scores with divisor n; the table lists the other readings.</source>
        <translation>论文未定义训练评价的方差。图中为学员得分的方差，除数为 n；表中列出其他算法。</translation>
    </message>
    <message>
        <source>This report is aggregated: it holds no line about a single person and no count of fewer than %1 people beside others.</source>
        <translation>本报告为汇总报告：不含任何个人的数据行，也不单列少于 %1 人的计数。</translation>
    </message>
    <message>
        <source>Time spent training and resting</source>
        <translation>训练与休息时间</translation>
    </message>
    <message>
        <source>Torsio is a training tool. It is not a medical device and holds no patient data.</source>
        <translation>Torsio 是训练工具，不是医疗器械，也不含患者数据。</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>学员</translation>
    </message>
    <message>
        <source>Trainees</source>
        <translation>学员数</translation>
    </message>
    <message>
        <source>Trainees who rested</source>
        <translation>休息过的学员数</translation>
    </message>
    <message>
        <source>Training formulas</source>
        <translation>训练公式</translation>
    </message>
    <message>
        <source>Training study</source>
        <translation>训练研究</translation>
    </message>
    <message>
        <source>Training study: groups at each occasion</source>
        <translation>训练研究：各评分时点的各组结果</translation>
    </message>
    <message>
        <source>Training study: score of every trainee</source>
        <translation>训练研究：各学员得分</translation>
    </message>
    <message>
        <source>Training study; Agreement and comparisons; Raters</source>
        <translation>训练研究；一致性与组间比较；评分者</translation>
    </message>
    <message>
        <source>Recorded runs</source>
        <translation>操作记录</translation>
    </message>
    <message>
        <source>Twist training: cohort report</source>
        <translation>扭转训练：批次报告</translation>
    </message>
    <message>
        <source>Twists</source>
        <translation>扭转次数</translation>
    </message>
    <message>
        <source>Upper quartile</source>
        <translation>上四分位数</translation>
    </message>
    <message>
        <source>Upper whisker</source>
        <translation>上须</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>数值个数</translation>
    </message>
    <message>
        <source>Variance of all marks, divisor n</source>
        <translation>全部评分的方差（除数 n）</translation>
    </message>
    <message>
        <source>Variance of each index about the weighted mean, divisor n</source>
        <translation>各指标围绕加权均值的方差（除数 n）</translation>
    </message>
    <message>
        <source>Variance of scores, divisor n</source>
        <translation>得分方差（除数 n）</translation>
    </message>
    <message>
        <source>Variance of scores, divisor n - 1</source>
        <translation>得分方差（除数 n - 1）</translation>
    </message>
    <message>
        <source>Variance of the trainee scores, divisor n</source>
        <translation>学员得分的方差（除数 n）</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>权重</translation>
    </message>
    <message>
        <source>Weighted mean score of each index</source>
        <translation>各指标的加权平均分</translation>
    </message>
    <message>
        <source>What each part is computed from</source>
        <translation>各部分的计算依据</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>情况说明</translation>
    </message>
    <message>
        <source>What is left out</source>
        <translation>未列出的内容</translation>
    </message>
    <message>
        <source>What was simulated</source>
        <translation>模拟的内容</translation>
    </message>
    <message>
        <source>When</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Where the numbers come from</source>
        <translation>数据的来源</translation>
    </message>
    <message>
        <source>With no mark missing, the class-weighted mean of the raters&apos; own scores equals N exactly.</source>
        <translation>评分无缺失时，各评分者得分按类别加权的均值恰等于 N。</translation>
    </message>
    <message>
        <source>Withdrew</source>
        <translation>退出</translation>
    </message>
    <message>
        <source>a factor of person %1 has no valid level</source>
        <translation>人员 %1 的某个因素没有有效水平</translation>
    </message>
    <message>
        <source>a group does not vary</source>
        <translation>有一组没有变异</translation>
    </message>
    <message>
        <source>a group has fewer than two trainees</source>
        <translation>有一组学员少于两名</translation>
    </message>
    <message>
        <source>a group is empty</source>
        <translation>有一组为空</translation>
    </message>
    <message>
        <source>a mark belongs to a group or an occasion that does not exist</source>
        <translation>某个评分所属的组或评分时点不存在</translation>
    </message>
    <message>
        <source>a score belongs to a group or an occasion that does not exist</source>
        <translation>某个得分所属的组或评分时点不存在</translation>
    </message>
    <message>
        <source>a study needs at least two persons and two raters</source>
        <translation>研究至少需要两名受评者和两名评分者</translation>
    </message>
    <message>
        <source>a study needs at least two persons, two raters and two occasions</source>
        <translation>研究至少需要两名受评者、两名评分者和两个评分时点</translation>
    </message>
    <message>
        <source>a study needs at least two persons, two tasks and two raters a task</source>
        <translation>研究至少需要两名受评者、两项任务且每项任务两名评分者</translation>
    </message>
    <message>
        <source>a summary belongs to a group or an occasion that does not exist</source>
        <translation>某项汇总所属的组或评分时点不存在</translation>
    </message>
    <message>
        <source>a trainee is in a group that does not exist</source>
        <translation>某名学员所在的组不存在</translation>
    </message>
    <message>
        <source>a value is not positive</source>
        <translation>有数值不为正</translation>
    </message>
    <message>
        <source>absolute angle error (deg)</source>
        <translation>绝对角度误差 (°)</translation>
    </message>
    <message>
        <source>after %1 min</source>
        <translation>%1 分钟后</translation>
    </message>
    <message>
        <source>aggregated, no line about a single person</source>
        <translation>汇总，不含个人数据行</translation>
    </message>
    <message>
        <source>all values are the same</source>
        <translation>所有数值相同</translation>
    </message>
    <message>
        <source>allocation design</source>
        <translation>分组方案</translation>
    </message>
    <message>
        <source>alpha needs at least two persons and two items</source>
        <translation>α 至少需要两名受评者和两个条目</translation>
    </message>
    <message>
        <source>an evaluation lacks an index</source>
        <translation>某项评价缺少指标</translation>
    </message>
    <message>
        <source>analysis of covariance, one pooled slope</source>
        <translation>协方差分析，共用斜率</translation>
    </message>
    <message>
        <source>analysis of variance, groups x occasions, type III</source>
        <translation>方差分析，组别 × 评分时点，III 型</translation>
    </message>
    <message>
        <source>as the others</source>
        <translation>与其余评分者相同</translation>
    </message>
    <message>
        <source>as they were when this report was made; not frozen</source>
        <translation>生成本报告时的状态；未冻结</translation>
    </message>
    <message>
        <source>before</source>
        <translation>训练前</translation>
    </message>
    <message>
        <source>block size %1 is no multiple of the number of arms</source>
        <translation>区组大小 %1 不是组数的整数倍</translation>
    </message>
    <message>
        <source>both raters use one and the same category only</source>
        <translation>两名评分者均只使用同一类别</translation>
    </message>
    <message>
        <source>changed since then</source>
        <translation>此后已改变</translation>
    </message>
    <message>
        <source>class means of Eq. 25</source>
        <translation>式 (25) 的类别均值</translation>
    </message>
    <message>
        <source>coded</source>
        <translation>以代码显示</translation>
    </message>
    <message>
        <source>cohort report</source>
        <translation>批次报告</translation>
    </message>
    <message>
        <source>completed</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>concordance needs at least two targets and two raters</source>
        <translation>一致性系数至少需要两个对象和两名评分者</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>计数</translation>
    </message>
    <message>
        <source>demonstration data</source>
        <translation>演示数据</translation>
    </message>
    <message>
        <source>difference (points)</source>
        <translation>差值（分）</translation>
    </message>
    <message>
        <source>difference [95 %]</source>
        <translation>差值 [95 %]</translation>
    </message>
    <message>
        <source>does not apply</source>
        <translation>不适用</translation>
    </message>
    <message>
        <source>each index uses the marks at hand (available case)</source>
        <translation>各指标采用现有评分（可用数据法）</translation>
    </message>
    <message>
        <source>every block ties all treatments</source>
        <translation>每个区组内各处理均同秩</translation>
    </message>
    <message>
        <source>every difference is zero</source>
        <translation>所有差值为零</translation>
    </message>
    <message>
        <source>every global mark is the same</source>
        <translation>所有总体评分相同</translation>
    </message>
    <message>
        <source>every rater ties all targets</source>
        <translation>每名评分者对所有对象均同秩</translation>
    </message>
    <message>
        <source>every rating is the same</source>
        <translation>所有评分相同</translation>
    </message>
    <message>
        <source>every resample lies on the same side of the estimate</source>
        <translation>所有重抽样结果均在估计值同一侧</translation>
    </message>
    <message>
        <source>every score is the same</source>
        <translation>所有得分相同</translation>
    </message>
    <message>
        <source>factor &quot;%1&quot; has no levels</source>
        <translation>因素“%1”没有水平</translation>
    </message>
    <message>
        <source>fewer than eight attempts cannot tell three parameters apart</source>
        <translation>不足八次无法区分三个参数</translation>
    </message>
    <message>
        <source>fewer than two persons or raters have ratings that are not extreme</source>
        <translation>非极端评分的受评者或评分者少于两名</translation>
    </message>
    <message>
        <source>group</source>
        <translation>组别</translation>
    </message>
    <message>
        <source>group %1: %2 and %3</source>
        <translation>第 %1 组 %2 和 %3</translation>
    </message>
    <message>
        <source>group summaries</source>
        <translation>各组汇总</translation>
    </message>
    <message>
        <source>group x occasion</source>
        <translation>组别 × 评分时点</translation>
    </message>
    <message>
        <source>high</source>
        <translation>上限</translation>
    </message>
    <message>
        <source>index</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>已中断</translation>
    </message>
    <message>
        <source>intraclass correlation</source>
        <translation>组内相关系数</translation>
    </message>
    <message>
        <source>kappa needs subjects and at least two categories</source>
        <translation>κ 需要受评对象和至少两个类别</translation>
    </message>
    <message>
        <source>limits of agreement need at least two pairs</source>
        <translation>一致性界限至少需要两对数据</translation>
    </message>
    <message>
        <source>low</source>
        <translation>下限</translation>
    </message>
    <message>
        <source>lower limit</source>
        <translation>下限</translation>
    </message>
    <message>
        <source>mark (points)</source>
        <translation>评分（分）</translation>
    </message>
    <message>
        <source>marks as submitted</source>
        <translation>提交的评分</translation>
    </message>
    <message>
        <source>marks at hand; weights of classes without marks are divided among the others (renormalised)</source>
        <translation>采用现有评分；无评分类别的权重按比例分给其余类别（重新归一化）</translation>
    </message>
    <message>
        <source>masters do not score higher than novices</source>
        <translation>熟练者得分不高于新手</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>均值</translation>
    </message>
    <message>
        <source>mean [95 %]</source>
        <translation>均值 [95 %]</translation>
    </message>
    <message>
        <source>mean of own mark and the others&apos; mean (points)</source>
        <translation>本人评分与其余均值的平均（分）</translation>
    </message>
    <message>
        <source>mean of own mark minus mean of the other raters</source>
        <translation>本人评分减其余评分者均值的平均</translation>
    </message>
    <message>
        <source>mean of the absolute error over trainees, Student&apos;s t</source>
        <translation>学员绝对误差的均值，t 分布</translation>
    </message>
    <message>
        <source>mean over raters</source>
        <translation>评分者均值</translation>
    </message>
    <message>
        <source>mean over raters; mean over trainees with Student&apos;s t</source>
        <translation>评分者均值；学员均值及 t 分布区间</translation>
    </message>
    <message>
        <source>mean over trainees</source>
        <translation>学员均值</translation>
    </message>
    <message>
        <source>minimisation needs a factor</source>
        <translation>最小化法需要一个因素</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>missing = %1</source>
        <translation>缺失 = %1</translation>
    </message>
    <message>
        <source>model parameters %1</source>
        <translation>模型参数 %1</translation>
    </message>
    <message>
        <source>named trainees</source>
        <translation>显示学员姓名</translation>
    </message>
    <message>
        <source>neither persons nor errors vary</source>
        <translation>受评者与误差均无变异</translation>
    </message>
    <message>
        <source>no block size is given</source>
        <translation>未给出区组大小</translation>
    </message>
    <message>
        <source>no difference</source>
        <translation>无差异</translation>
    </message>
    <message>
        <source>no disagreement has any weight</source>
        <translation>没有任何分歧带有权重</translation>
    </message>
    <message>
        <source>no resample has any variation</source>
        <translation>重抽样结果均无变异</translation>
    </message>
    <message>
        <source>no unit has two ratings</source>
        <translation>没有对象具有两个评分</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>none allowed</source>
        <translation>不允许缺失</translation>
    </message>
    <message>
        <source>none on the simulator</source>
        <translation>模拟器上无</translation>
    </message>
    <message>
        <source>not computed</source>
        <translation>未计算</translation>
    </message>
    <message>
        <source>not counted</source>
        <translation>未计算</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>无定义</translation>
    </message>
    <message>
        <source>not defined: %1</source>
        <translation>无定义：%1</translation>
    </message>
    <message>
        <source>not fitted: %1</source>
        <translation>未拟合：%1</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>未记录</translation>
    </message>
    <message>
        <source>not shown (fewer than %1)</source>
        <translation>不显示（少于 %1）</translation>
    </message>
    <message>
        <source>number of the twist</source>
        <translation>扭转序号</translation>
    </message>
    <message>
        <source>offset [95 %]</source>
        <translation>偏差 [95 %]</translation>
    </message>
    <message>
        <source>one mark</source>
        <translation>单个评分</translation>
    </message>
    <message>
        <source>one of the two does not vary</source>
        <translation>两者之一没有变异</translation>
    </message>
    <message>
        <source>only one category was used</source>
        <translation>只使用了一个类别</translation>
    </message>
    <message>
        <source>organ %1</source>
        <translation>器官 %1</translation>
    </message>
    <message>
        <source>outside the whiskers</source>
        <translation>须线之外</translation>
    </message>
    <message>
        <source>own mark minus the other raters&apos; mean (points)</source>
        <translation>本人评分减其余评分者均值（分）</translation>
    </message>
    <message>
        <source>own minus others&apos; mean</source>
        <translation>本人减其余均值（分）</translation>
    </message>
    <message>
        <source>p (Greenhouse-Geisser)</source>
        <translation>p (Greenhouse-Geisser)</translation>
    </message>
    <message>
        <source>p (Holm)</source>
        <translation>p (Holm)</translation>
    </message>
    <message>
        <source>p (exact)</source>
        <translation>p（精确）</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>第 %1 页，共 %2 页</translation>
    </message>
    <message>
        <source>person %1 is already allocated</source>
        <translation>人员 %1 已分组</translation>
    </message>
    <message>
        <source>rater</source>
        <translation>评分者</translation>
    </message>
    <message>
        <source>raters with a missing mark are left out (list-wise)</source>
        <translation>剔除有缺失评分的评分者（成列删除）</translation>
    </message>
    <message>
        <source>ratings and evaluations name different models</source>
        <translation>评分与评价中的模型不一致</translation>
    </message>
    <message>
        <source>record %1 does not fit into the chain</source>
        <translation>第 %1 条记录与链不符</translation>
    </message>
    <message>
        <source>record %1 does not follow from the seed</source>
        <translation>第 %1 条记录与种子不符</translation>
    </message>
    <message>
        <source>recordings, listed below</source>
        <translation>录制，列于下表</translation>
    </message>
    <message>
        <source>reports are not written in this language</source>
        <translation>报告不支持该语言</translation>
    </message>
    <message>
        <source>s2 (Eq. 26)</source>
        <translation>s²（式 26）</translation>
    </message>
    <message>
        <source>s2 is taken about M with divisor n (Eq. 26). The sample variance is taken about the plain mean with divisor n - 1. SE is the standard error of M from the spread within the rater classes.</source>
        <translation>s² 以 M 为中心，除数为 n（式 26）。样本方差以算术均值为中心，除数为 n - 1。标准误为由各评分者类别内离散程度得出的 M 的标准误。</translation>
    </message>
    <message>
        <source>score (points)</source>
        <translation>得分（分）</translation>
    </message>
    <message>
        <source>sealed until the study ends</source>
        <translation>封存至研究结束</translation>
    </message>
    <message>
        <source>stratified blocks need a factor</source>
        <translation>分层区组需要一个因素</translation>
    </message>
    <message>
        <source>submitted marks of the campaign</source>
        <translation>该次评价中提交的评分</translation>
    </message>
    <message>
        <source>submitted marks of the occasions</source>
        <translation>各评分时点提交的评分</translation>
    </message>
    <message>
        <source>the allocation list is used up</source>
        <translation>分组表已用完</translation>
    </message>
    <message>
        <source>the class of chief physicians does not exist</source>
        <translation>主任医师类别不存在</translation>
    </message>
    <message>
        <source>the column %1 holds &quot;%2&quot;, which this version does not know</source>
        <translation>列 %1 中的“%2”不为此版本所知</translation>
    </message>
    <message>
        <source>the curve passes through every point</source>
        <translation>曲线通过每一个点</translation>
    </message>
    <message>
        <source>the differences do not vary</source>
        <translation>差值没有变异</translation>
    </message>
    <message>
        <source>the experts do not differ</source>
        <translation>各专家之间没有差异</translation>
    </message>
    <message>
        <source>the fit does not settle</source>
        <translation>拟合不收敛</translation>
    </message>
    <message>
        <source>the fitted normals do not cross between the means</source>
        <translation>拟合的两条正态曲线在均值之间不相交</translation>
    </message>
    <message>
        <source>the manifest does not fit its hash: the database was tampered with</source>
        <translation>清单与其哈希不符：数据库曾被篡改</translation>
    </message>
    <message>
        <source>the number of participants is no multiple of the number of arms</source>
        <translation>参与者人数不是组数的整数倍</translation>
    </message>
    <message>
        <source>the parameters cannot be told apart</source>
        <translation>参数无法区分</translation>
    </message>
    <message>
        <source>the probability of the best arm must lie between 0.5 and 0.9; 1 could be predicted</source>
        <translation>最优组的概率须在 0.5 至 0.9 之间；取 1 时结果可被预测</translation>
    </message>
    <message>
        <source>the rating plan falls into parts that share no person and no rater</source>
        <translation>评分方案分裂为互不共享受评者和评分者的部分</translation>
    </message>
    <message>
        <source>the scores after follow the scores before exactly</source>
        <translation>训练后得分完全由训练前得分决定</translation>
    </message>
    <message>
        <source>the scores before do not vary in one group</source>
        <translation>有一组训练前得分没有变异</translation>
    </message>
    <message>
        <source>the scores before do not vary within groups</source>
        <translation>训练前得分在组内没有变异</translation>
    </message>
    <message>
        <source>the start lies outside the domain of the curve</source>
        <translation>起点在曲线的定义域之外</translation>
    </message>
    <message>
        <source>the statistic does not change with any trainee</source>
        <translation>去掉任一学员该统计量均不变</translation>
    </message>
    <message>
        <source>the sums over the items do not vary</source>
        <translation>条目总分没有变异</translation>
    </message>
    <message>
        <source>the targets do not differ</source>
        <translation>各对象之间没有差异</translation>
    </message>
    <message>
        <source>the test is made for 4 to 5000 values</source>
        <translation>该检验适用于 4 至 5000 个数值</translation>
    </message>
    <message>
        <source>the test needs at least two blocks and two treatments</source>
        <translation>该检验至少需要两个区组和两种处理</translation>
    </message>
    <message>
        <source>the values do not differ under this metric</source>
        <translation>在该度量下数值没有差异</translation>
    </message>
    <message>
        <source>the values do not vary</source>
        <translation>数值没有变异</translation>
    </message>
    <message>
        <source>the values do not vary within groups</source>
        <translation>组内数值没有变异</translation>
    </message>
    <message>
        <source>there are fewer than three attempts</source>
        <translation>尝试少于三次</translation>
    </message>
    <message>
        <source>there are fewer than three trainees</source>
        <translation>学员少于三名</translation>
    </message>
    <message>
        <source>there are fewer than two arms</source>
        <translation>少于两组</translation>
    </message>
    <message>
        <source>there are fewer than two categories</source>
        <translation>少于两个类别</translation>
    </message>
    <message>
        <source>there are fewer than two coders</source>
        <translation>编码者少于两名</translation>
    </message>
    <message>
        <source>there are fewer than two experts</source>
        <translation>专家少于两名</translation>
    </message>
    <message>
        <source>there are fewer than two occasions</source>
        <translation>评分时点少于两个</translation>
    </message>
    <message>
        <source>there are fewer than two pairs</source>
        <translation>少于两对数据</translation>
    </message>
    <message>
        <source>there are fewer than two raters</source>
        <translation>评分者少于两名</translation>
    </message>
    <message>
        <source>there are fewer than two targets</source>
        <translation>对象少于两个</translation>
    </message>
    <message>
        <source>there are no judges</source>
        <translation>没有评判者</translation>
    </message>
    <message>
        <source>there are no pairs</source>
        <translation>没有成对数据</translation>
    </message>
    <message>
        <source>there are no ratings</source>
        <translation>没有评分</translation>
    </message>
    <message>
        <source>there are too few points for the parameters</source>
        <translation>相对于参数个数数据点过少</translation>
    </message>
    <message>
        <source>there are too few trainees</source>
        <translation>学员过少</translation>
    </message>
    <message>
        <source>there are too few trainees for the number of occasions</source>
        <translation>相对于评分时点数学员过少</translation>
    </message>
    <message>
        <source>there is no residual variation</source>
        <translation>没有残差变异</translation>
    </message>
    <message>
        <source>too few</source>
        <translation>过少</translation>
    </message>
    <message>
        <source>too few trainees for separate slopes</source>
        <translation>学员过少，无法分别估计斜率</translation>
    </message>
    <message>
        <source>trainee number in the group</source>
        <translation>组内学员序号</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>未改变</translation>
    </message>
    <message>
        <source>upper limit</source>
        <translation>上限</translation>
    </message>
    <message>
        <source>value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>variance (points squared)</source>
        <translation>方差（分²）</translation>
    </message>
    <message>
        <source>variance of trainee scores, divisor n</source>
        <translation>学员得分的方差，除数 n</translation>
    </message>
    <message>
        <source>whole cohort</source>
        <translation>整个批次</translation>
    </message>
    <message>
        <source>z (Dunn)</source>
        <translation>z (Dunn)</translation>
    </message>
    <message>
        <source>Right forearm</source>
        <translation>右前臂</translation>
    </message>
    <message>
        <source>Stomach</source>
        <translation>胃</translation>
    </message>
    <message>
        <source>Small intestine, loop</source>
        <translation>小肠袢</translation>
    </message>
    <message>
        <source>synthetic, drawn by torsio_make_organs from ANSUR II means</source>
        <translation>合成，由 torsio_make_organs 按 ANSUR II 均值绘制</translation>
    </message>
    <message>
        <source>synthetic, drawn by torsio_make_organs from published dimensions</source>
        <translation>合成，由 torsio_make_organs 按已发表尺寸绘制</translation>
    </message>
    <message>
        <source>Simulated trainees after section 6 of the paper</source>
        <translation>按论文第 6 节模拟的学员</translation>
    </message>
    <message>
        <source>Allocation locked</source>
        <translation>锁定随机分组</translation>
    </message>
    <message>
        <source>Allocation replaced by a new one</source>
        <translation>以新方案取代随机分组</translation>
    </message>
    <message>
        <source>Audit trail verified</source>
        <translation>核验审计记录</translation>
    </message>
    <message>
        <source>Backup restored</source>
        <translation>恢复备份</translation>
    </message>
    <message>
        <source>Centre renamed</source>
        <translation>中心已更名</translation>
    </message>
    <message>
        <source>Centre set up</source>
        <translation>设立中心</translation>
    </message>
    <message>
        <source>Classes of raters set up</source>
        <translation>设置评分者类别</translation>
    </message>
    <message>
        <source>Cohort added</source>
        <translation>添加批次</translation>
    </message>
    <message>
        <source>Consent recorded</source>
        <translation>记录同意</translation>
    </message>
    <message>
        <source>Curriculum added</source>
        <translation>添加课程</translation>
    </message>
    <message>
        <source>Curriculum closed</source>
        <translation>关闭课程</translation>
    </message>
    <message>
        <source>Curriculum given to a cohort</source>
        <translation>为批次指定课程</translation>
    </message>
    <message>
        <source>Curriculum published</source>
        <translation>发布课程</translation>
    </message>
    <message>
        <source>Curriculum put into use</source>
        <translation>启用课程</translation>
    </message>
    <message>
        <source>Data set frozen</source>
        <translation>冻结数据集</translation>
    </message>
    <message>
        <source>Database checked</source>
        <translation>检查数据库</translation>
    </message>
    <message>
        <source>Decided about their own consent</source>
        <translation>本人就同意作出决定</translation>
    </message>
    <message>
        <source>Demonstration data removed</source>
        <translation>删除演示数据</translation>
    </message>
    <message>
        <source>Deviation reported</source>
        <translation>报告方案偏离</translation>
    </message>
    <message>
        <source>Draft of a curriculum saved</source>
        <translation>保存课程草稿</translation>
    </message>
    <message>
        <source>Evaluation campaign added</source>
        <translation>添加模型评价</translation>
    </message>
    <message>
        <source>Evaluation form submitted</source>
        <translation>提交评价表</translation>
    </message>
    <message>
        <source>Evaluation mark amended</source>
        <translation>更正评价评分</translation>
    </message>
    <message>
        <source>Evaluation mark submitted</source>
        <translation>提交评价评分</translation>
    </message>
    <message>
        <source>Everything about a person exported</source>
        <translation>导出某人的全部资料</translation>
    </message>
    <message>
        <source>Group of a trainee changed by hand</source>
        <translation>手动更改学员分组</translation>
    </message>
    <message>
        <source>Seed of the allocation opened</source>
        <translation>启封分组种子</translation>
    </message>
    <message>
        <source>Groups drawn</source>
        <translation>抽取分组</translation>
    </message>
    <message>
        <source>Identity of a person erased</source>
        <translation>删除人员身份信息</translation>
    </message>
    <message>
        <source>Interrupted recording closed</source>
        <translation>结束中断的录制</translation>
    </message>
    <message>
        <source>List of people exported under codes</source>
        <translation>导出人员名单（仅代码）</translation>
    </message>
    <message>
        <source>List of people exported with names</source>
        <translation>导出人员名单（含姓名）</translation>
    </message>
    <message>
        <source>Mark amended</source>
        <translation>更正评分</translation>
    </message>
    <message>
        <source>Mark submitted</source>
        <translation>提交评分</translation>
    </message>
    <message>
        <source>Marks are still missing from: %1.</source>
        <translation>仍缺少以下评分者类别的评分：%1。</translation>
    </message>
    <message>
        <source>Marks released to trainees</source>
        <translation>向学员公布评分</translation>
    </message>
    <message>
        <source>Moment of a recording bookmarked</source>
        <translation>为录制添加书签</translation>
    </message>
    <message>
        <source>Move to a server begun</source>
        <translation>开始迁移至服务器</translation>
    </message>
    <message>
        <source>Move to a server given up</source>
        <translation>放弃迁移至服务器</translation>
    </message>
    <message>
        <source>Own mark kept in the discrepancy review</source>
        <translation>评分分歧复核：保留自己的评分</translation>
    </message>
    <message>
        <source>Own mark amended in the discrepancy review</source>
        <translation>评分分歧复核：修订自己的评分</translation>
    </message>
    <message>
        <source>Own password changed</source>
        <translation>修改自己的密码</translation>
    </message>
    <message>
        <source>Own recording scored</source>
        <translation>为自己的录制评分</translation>
    </message>
    <message>
        <source>PIN removed</source>
        <translation>删除 PIN</translation>
    </message>
    <message>
        <source>PIN set</source>
        <translation>设置 PIN</translation>
    </message>
    <message>
        <source>Password of a user reset</source>
        <translation>重置用户密码</translation>
    </message>
    <message>
        <source>Person changed</source>
        <translation>修改人员资料</translation>
    </message>
    <message>
        <source>Person entered</source>
        <translation>录入人员</translation>
    </message>
    <message>
        <source>Question answered</source>
        <translation>回答问题</translation>
    </message>
    <message>
        <source>Question asked</source>
        <translation>提出问题</translation>
    </message>
    <message>
        <source>Record backed up</source>
        <translation>备份数据库</translation>
    </message>
    <message>
        <source>Record kept longer</source>
        <translation>延长记录保存期</translation>
    </message>
    <message>
        <source>Record locked against erasing</source>
        <translation>锁定记录以防删除</translation>
    </message>
    <message>
        <source>Record released for erasing</source>
        <translation>解除记录的保留</translation>
    </message>
    <message>
        <source>Recording finished</source>
        <translation>录制完成</translation>
    </message>
    <message>
        <source>Recording interrupted</source>
        <translation>录制中断</translation>
    </message>
    <message>
        <source>Recording stored from a file</source>
        <translation>从文件存入录制</translation>
    </message>
    <message>
        <source>Reference run chosen</source>
        <translation>选定参考操作</translation>
    </message>
    <message>
        <source>Reference run scored for rater calibration</source>
        <translation>评分校准：为参考操作评分</translation>
    </message>
    <message>
        <source>Reference run withdrawn</source>
        <translation>参考操作已撤回</translation>
    </message>
    <message>
        <source>Release of marks taken back</source>
        <translation>撤回评分公布</translation>
    </message>
    <message>
        <source>Remark answered</source>
        <translation>回复评语</translation>
    </message>
    <message>
        <source>Remark read</source>
        <translation>阅读评语</translation>
    </message>
    <message>
        <source>Remark written</source>
        <translation>撰写评语</translation>
    </message>
    <message>
        <source>Report exported under codes</source>
        <translation>导出报告（仅代码）</translation>
    </message>
    <message>
        <source>Report exported with names</source>
        <translation>导出报告（含姓名）</translation>
    </message>
    <message>
        <source>Restoring a backup begun</source>
        <translation>开始恢复备份</translation>
    </message>
    <message>
        <source>Roles of a user changed</source>
        <translation>更改用户角色</translation>
    </message>
    <message>
        <source>Roster imported</source>
        <translation>导入名册</translation>
    </message>
    <message>
        <source>Rule for keeping records changed</source>
        <translation>更改记录保存规则</translation>
    </message>
    <message>
        <source>Say why, in a few words</source>
        <translation>请用几个字说明理由</translation>
    </message>
    <message>
        <source>Scoring assigned</source>
        <translation>分配评分任务</translation>
    </message>
    <message>
        <source>Scoring given to another rater</source>
        <translation>评分任务转交其他评分者</translation>
    </message>
    <message>
        <source>Rubric added</source>
        <translation>添加评分标准</translation>
    </message>
    <message>
        <source>Rubric revised</source>
        <translation>修订评分标准</translation>
    </message>
    <message>
        <source>Scoring withdrawn from a rater</source>
        <translation>收回评分任务</translation>
    </message>
    <message>
        <source>Sealed cards printed</source>
        <translation>打印密封卡片</translation>
    </message>
    <message>
        <source>Setting changed</source>
        <translation>更改设置</translation>
    </message>
    <message>
        <source>Sheet amended</source>
        <translation>更正评分表</translation>
    </message>
    <message>
        <source>Sheet submitted</source>
        <translation>提交评分表</translation>
    </message>
    <message>
        <source>Sign-in failed</source>
        <translation>登录失败</translation>
    </message>
    <message>
        <source>Signed in</source>
        <translation>登录</translation>
    </message>
    <message>
        <source>Signed in to practise only</source>
        <translation>登录（仅练习）</translation>
    </message>
    <message>
        <source>Signed out</source>
        <translation>退出登录</translation>
    </message>
    <message>
        <source>Start password for %1</source>
        <translation>%1 的初始密码</translation>
    </message>
    <message>
        <source>State of a person changed</source>
        <translation>更改人员状态</translation>
    </message>
    <message>
        <source>Station joined the record of a server</source>
        <translation>工作站加入服务器上的数据库</translation>
    </message>
    <message>
        <source>Station turned to the server</source>
        <translation>工作站改用服务器</translation>
    </message>
    <message>
        <source>Taking part in the study changed</source>
        <translation>更改参与研究的状态</translation>
    </message>
    <message>
        <source>Adjudicator requested</source>
        <translation>请求仲裁评分者</translation>
    </message>
    <message>
        <source>Adjudicator assigned</source>
        <translation>指派仲裁评分者</translation>
    </message>
    <message>
        <source>Trainee enrolled</source>
        <translation>登记学员</translation>
    </message>
    <message>
        <source>Training time logged</source>
        <translation>登记训练时间</translation>
    </message>
    <message>
        <source>Training transcript made</source>
        <translation>生成培训成绩单</translation>
    </message>
    <message>
        <source>User added</source>
        <translation>添加用户</translation>
    </message>
    <message>
        <source>User disabled</source>
        <translation>停用用户</translation>
    </message>
    <message>
        <source>User enabled</source>
        <translation>启用用户</translation>
    </message>
    <message>
        <source>Withdrawal of consent recorded</source>
        <translation>记录撤回同意</translation>
    </message>
    <message>
        <source>audit trail</source>
        <translation>审计记录</translation>
    </message>
    <message>
        <source>class of raters</source>
        <translation>评分者类别</translation>
    </message>
    <message>
        <source>draft of a curriculum</source>
        <translation>课程草稿</translation>
    </message>
    <message>
        <source>enrolled trainee</source>
        <translation>登记的学员</translation>
    </message>
    <message>
        <source>evaluation campaign</source>
        <translation>模型评价</translation>
    </message>
    <message>
        <source>evaluation mark</source>
        <translation>评价评分</translation>
    </message>
    <message>
        <source>frozen data set</source>
        <translation>冻结的数据集</translation>
    </message>
    <message>
        <source>group of a trainee</source>
        <translation>学员分组</translation>
    </message>
    <message>
        <source>mark</source>
        <translation>评分</translation>
    </message>
    <message>
        <source>person</source>
        <translation>人员</translation>
    </message>
    <message>
        <source>question</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>record</source>
        <translation>数据库</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>reference run</source>
        <translation>参考操作</translation>
    </message>
    <message>
        <source>release of marks</source>
        <translation>评分公布</translation>
    </message>
    <message>
        <source>remark</source>
        <translation>评语</translation>
    </message>
    <message>
        <source>rule for keeping records</source>
        <translation>记录保存规则</translation>
    </message>
    <message>
        <source>assignment</source>
        <translation>评分任务</translation>
    </message>
    <message>
        <source>setting</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>the force is not felt</source>
        <translation>感觉不到力反馈</translation>
    </message>
    <message>
        <source>this recording is no reference run, or was withdrawn already</source>
        <translation>此录制不是参考操作，或已被撤回</translation>
    </message>
    <message>
        <source>this recording is or was a reference run</source>
        <translation>此录制是或曾是参考操作</translation>
    </message>
    <message>
        <source>training time</source>
        <translation>训练时间</translation>
    </message>
    <message>
        <source>user</source>
        <translation>用户</translation>
    </message>
    <message>
        <source>version of a curriculum</source>
        <translation>课程版本</translation>
    </message>
    <message>
        <source>rater calibration</source>
        <translation>评分校准</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>“%1”不是数字</translation>
    </message>
    <message>
        <source>Write it like 90 or 22.5</source>
        <translation>请写成 90 或 22.5 的形式</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a size</source>
        <translation>“%1”不是尺寸</translation>
    </message>
    <message>
        <source>Write it like 1280x800; 320x240 to 7680x4320</source>
        <translation>请写成 1280x800 的形式；320x240 至 7680x4320</translation>
    </message>
    <message>
        <source>Use one of: %1</source>
        <translation>请使用下列之一：%1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no option</source>
        <translation>“%1”不是选项</translation>
    </message>
    <message>
        <source>See torsio --help</source>
        <translation>参见 torsio --help</translation>
    </message>
    <message>
        <source>the estimates lie too far apart to be computed</source>
        <translation>估计值相距过远，无法计算</translation>
    </message>
    <message>
        <source>List of recordings exported under codes</source>
        <translation>导出录制列表（仅代码）</translation>
    </message>
    <message>
        <source>Single marks exported under codes</source>
        <translation>导出单项评分（仅代码）</translation>
    </message>
    <message>
        <source>the tasks have different numbers of raters</source>
        <translation>各任务的评分者人数不同</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>未读取</translation>
    </message>
    <message>
        <source>Checking the audit trail</source>
        <translation>正在检查审计记录</translation>
    </message>
    <message>
        <source>Checking the audit trail of the copy</source>
        <translation>正在检查副本的审计记录</translation>
    </message>
    <message>
        <source>Checking tables and references</source>
        <translation>正在检查数据表和引用</translation>
    </message>
    <message>
        <source>Copying</source>
        <translation>正在复制</translation>
    </message>
    <message>
        <source>Reading the backup</source>
        <translation>正在读取备份</translation>
    </message>
    <message>
        <source>Copying the record while others work</source>
        <translation>正在复制记录，他人可继续工作</translation>
    </message>
    <message>
        <source>Reading the backup from end to end</source>
        <translation>正在从头到尾读取备份</translation>
    </message>
    <message>
        <source>Backing up the record as it is now</source>
        <translation>正在备份当前记录</translation>
    </message>
    <message>
        <source>Preparing the restored record</source>
        <translation>正在准备恢复的记录</translation>
    </message>
    <message>
        <source>Checking the restored record</source>
        <translation>正在检查已恢复的记录</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Looking at the server</source>
        <translation>正在查看服务器</translation>
    </message>
    <message>
        <source>female, male or other</source>
        <translation>女、男或其他</translation>
    </message>
    <message>
        <source>left or right</source>
        <translation>左或右</translation>
    </message>
    <message>
        <source>seed and design do not give the published commitment</source>
        <translation>由种子和设计得不到已公布的承诺值</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>必须为 true 或 false</translation>
    </message>
    <message>
        <source>must list codes of modules</source>
        <translation>须列出模块代码</translation>
    </message>
    <message>
        <source>Put them in quotes.</source>
        <translation>请加上引号。</translation>
    </message>
    <message>
        <source>there are fewer than two samples</source>
        <translation>采样不足两个</translation>
    </message>
    <message>
        <source>samples are missing for more than 20 ms</source>
        <translation>采样缺失超过 20 ms</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>未测量</translation>
    </message>
    <message>
        <source>nothing moved</source>
        <translation>没有任何移动</translation>
    </message>
    <message>
        <source>the movement is longer than a minute: split it into movements</source>
        <translation>该动作超过一分钟：请拆分为多个动作</translation>
    </message>
    <message>
        <source>the speed has no spectrum below the cut-off</source>
        <translation>速度在截止频率以下没有频谱</translation>
    </message>
    <message>
        <source>the speed is constant</source>
        <translation>速度恒定不变</translation>
    </message>
    <message>
        <source>the tool never held the organ</source>
        <translation>器械从未夹持器官</translation>
    </message>
    <message>
        <source>there are no samples</source>
        <translation>没有采样</translation>
    </message>
    <message>
        <source>the angle was never held</source>
        <translation>从未保持角度</translation>
    </message>
    <message>
        <source>the organ was never released</source>
        <translation>从未松开器官</translation>
    </message>
    <message>
        <source>the target was not reached</source>
        <translation>未达到目标</translation>
    </message>
    <message>
        <source>the angle did not settle</source>
        <translation>角度未稳定</translation>
    </message>
    <message>
        <source>the target does not move</source>
        <translation>目标不移动</translation>
    </message>
    <message>
        <source>not applicable</source>
        <translation>不适用</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>已锁定</translation>
    </message>
    <message>
        <source>kept longer</source>
        <translation>延长保存</translation>
    </message>
    <message>
        <source>released</source>
        <translation>已解除</translation>
    </message>
    <message>
        <source>Cohort report</source>
        <translation>批次报告</translation>
    </message>
    <message>
        <source>a group has fewer than two values</source>
        <translation>某组的数值不足两个</translation>
    </message>
    <message>
        <source>category %1 is never used: collapse categories first</source>
        <translation>类别 %1 从未使用：请先合并类别</translation>
    </message>
    <message>
        <source>the likelihood has no finite maximum: nothing in the ratings bounds %1</source>
        <translation>似然函数没有有限的最大值：评分无法界定 %1</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>练习</translation>
    </message>
    <message>
        <source>Graded</source>
        <translation>计分</translation>
    </message>
    <message>
        <source>virtual</source>
        <translation>虚拟</translation>
    </message>
    <message>
        <source>real</source>
        <translation>真实</translation>
    </message>
    <message>
        <source>enrolled</source>
        <translation>已登记</translation>
    </message>
    <message>
        <source>published, not begun</source>
        <translation>已发布，未启用</translation>
    </message>
    <message>
        <source>running</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>已关闭</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>已保留</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>已修改</translation>
    </message>
    <message>
        <source>adjudicator requested</source>
        <translation>已请求仲裁</translation>
    </message>
    <message>
        <source>this mark</source>
        <translation>该评分</translation>
    </message>
    <message>
        <source>this frozen data set</source>
        <translation>该冻结数据集</translation>
    </message>
    <message>
        <source>this remark</source>
        <translation>该评语</translation>
    </message>
    <message>
        <source>this self-score</source>
        <translation>该自评</translation>
    </message>
    <message>
        <source>Give two end points further apart, or a smaller cap radius.</source>
        <translation>请给出相距更远的两个端点，或减小端盖半径。</translation>
    </message>
    <message>
        <source>Use the harmonic mode, or move the end points off branches and fingers.</source>
        <translation>请使用调和模式，或将端点移离分支和手指。</translation>
    </message>
    <message>
        <source>Check the mesh for thin spikes, or give other end points.</source>
        <translation>请检查网格是否有细小尖刺，或另行指定端点。</translation>
    </message>
    <message>
        <source>Give the two end points of the axis, or use the harmonic mode.</source>
        <translation>请给出轴线的两个端点，或使用调和模式。</translation>
    </message>
    <message>
        <source>a face needs its number of corners and as many indices</source>
        <translation>每个面须给出角点数和相同数量的索引</translation>
    </message>
    <message>
        <source>an index is not a whole number</source>
        <translation>索引不是整数</translation>
    </message>
    <message>
        <source>it is not text</source>
        <translation>不是文本</translation>
    </message>
    <message>
        <source>it does not begin with OFF or COFF</source>
        <translation>文件开头不是 OFF 或 COFF</translation>
    </message>
    <message>
        <source>no counts follow the first word</source>
        <translation>首个词之后没有数量</translation>
    </message>
    <message>
        <source>a vertex needs three numbers</source>
        <translation>顶点需要三个数字</translation>
    </message>
    <message>
        <source>a property stands before any element</source>
        <translation>属性出现在所有元素之前</translation>
    </message>
    <message>
        <source>a property without type and name</source>
        <translation>属性缺少类型和名称</translation>
    </message>
    <message>
        <source>a property of unknown type</source>
        <translation>属性的类型未知</translation>
    </message>
    <message>
        <source>vertex indices that are not integers</source>
        <translation>顶点索引不是整数</translation>
    </message>
    <message>
        <source>unknown kind of format</source>
        <translation>格式种类未知</translation>
    </message>
    <message>
        <source>an element without a count</source>
        <translation>元素缺少数量</translation>
    </message>
    <message>
        <source>the first line is not &quot;ply&quot;</source>
        <translation>首行不是“ply”</translation>
    </message>
    <message>
        <source>the header has no end</source>
        <translation>文件头没有结束标记</translation>
    </message>
    <message>
        <source>values are missing</source>
        <translation>缺少数值</translation>
    </message>
    <message>
        <source>the length of a list is no count</source>
        <translation>列表长度不是有效数量</translation>
    </message>
    <message>
        <source>a value is not a number</source>
        <translation>某个值不是数字</translation>
    </message>
    <message>
        <source>it has more values than declared</source>
        <translation>数值多于所声明的数量</translation>
    </message>
    <message>
        <source>the file ends early</source>
        <translation>文件提前结束</translation>
    </message>
    <message>
        <source>points nowhere</source>
        <translation>没有指向任何方向</translation>
    </message>
    <message>
        <source>Give a direction that is not zero.</source>
        <translation>请给出非零方向。</translation>
    </message>
    <message>
        <source>must list at least one</source>
        <translation>至少须列出一项</translation>
    </message>
    <message>
        <source>Add a pattern.</source>
        <translation>请添加一个模式。</translation>
    </message>
    <message>
        <source>three force axes</source>
        <translation>三个力轴</translation>
    </message>
    <message>
        <source>usable workspace</source>
        <translation>可用工作空间</translation>
    </message>
    <message>
        <source>on the simulator</source>
        <translation>在模拟器上</translation>
    </message>
    <message>
        <source>on the real arm</source>
        <translation>在实物手臂上</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>休息</translation>
    </message>
    <message>
        <source>active</source>
        <translation>在册</translation>
    </message>
    <message>
        <source>erased</source>
        <translation>已删除身份信息</translation>
    </message>
    <message>
        <source>has left</source>
        <translation>已离开</translation>
    </message>
    <message>
        <source>det F, the local volume ratio, falls to %1</source>
        <translation>局部体积比 det F 降至 %1</translation>
    </message>
    <message>
        <source>the volume becomes %1 of what it was</source>
        <translation>体积变为原来的 %1 倍</translation>
    </message>
    <message>
        <source>the shear modulus is %1 Pa, but must be above 0</source>
        <translation>剪切模量为 %1 Pa，但必须大于 0</translation>
    </message>
    <message>
        <source>material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Give G in pascal; for nearly incompressible tissue it is E / 3.</source>
        <translation>请以帕斯卡给出 G；近似不可压缩组织的 G 为 E / 3。</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio is %1, but must lie in 0..0.5</source>
        <translation>泊松比为 %1，但必须在 0 至 0.5 之间</translation>
    </message>
    <message>
        <source>Give 0.5 for incompressible tissue.</source>
        <translation>不可压缩组织请取 0.5。</translation>
    </message>
    <message>
        <source>rod</source>
        <translation>杆模型</translation>
    </message>
    <message>
        <source>Choose a number inside the range.</source>
        <translation>请选择范围内的数值。</translation>
    </message>
    <message>
        <source>the section %1 mm from the fixed end</source>
        <translation>距固定端 %1 毫米处的截面</translation>
    </message>
    <message>
        <source>load average %1</source>
        <translation>系统负载 %1</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>处理器</translation>
    </message>
    <message>
        <source>Cores</source>
        <translation>核心数</translation>
    </message>
    <message>
        <source>Load average at the start</source>
        <translation>开始时的系统负载</translation>
    </message>
    <message>
        <source>Compiler</source>
        <translation>编译器</translation>
    </message>
    <message>
        <source>Instruction set of the view</source>
        <translation>显示所用指令集</translation>
    </message>
    <message>
        <source>Lattice</source>
        <translation>网格线</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Torque at the free end</source>
        <translation>自由端扭矩</translation>
    </message>
    <message>
        <source>Shear modulus</source>
        <translation>剪切模量</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio of the elements</source>
        <translation>单元的泊松比</translation>
    </message>
    <message>
        <source>Deformation time (Fig. 10), powers of ten</source>
        <translation>形变时间（图 10），以 10 的幂表示</translation>
    </message>
    <message>
        <source>model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>log10 of seconds of processing</source>
        <translation>计算秒数的 log10</translation>
    </message>
    <message>
        <source>whole twist</source>
        <translation>整个扭转</translation>
    </message>
    <message>
        <source>one frame</source>
        <translation>单帧</translation>
    </message>
    <message>
        <source>set-up</source>
        <translation>准备</translation>
    </message>
    <message>
        <source>The reference has no frames: its values are one step of the torque and all of them. Set-up is not part of the deformation time.</source>
        <translation>参考解没有帧：其数值分别为一个扭矩步和全部扭矩步。准备时间不计入形变时间。</translation>
    </message>
    <message>
        <source>processing time</source>
        <translation>计算时间</translation>
    </message>
    <message>
        <source>Displacement of the markers in equilibrium (Fig. 13)</source>
        <translation>平衡时各标记点的位移（图 13）</translation>
    </message>
    <message>
        <source>marker</source>
        <translation>标记点</translation>
    </message>
    <message>
        <source>displacement (mm)</source>
        <translation>位移（mm）</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>Eq. 24</source>
        <translation>式 (24)</translation>
    </message>
    <message>
        <source>Displacement of marker %1 during the twist (Fig. 14)</source>
        <translation>扭转过程中标记点 %1 的位移（图 14）</translation>
    </message>
    <message>
        <source>time (s)</source>
        <translation>时间（s）</translation>
    </message>
    <message>
        <source>Accuracy in equilibrium, against the reference</source>
        <translation>平衡时相对参考解的精度</translation>
    </message>
    <message>
        <source>end angle (deg)</source>
        <translation>端部角度（°）</translation>
    </message>
    <message>
        <source>RMSE (mm)</source>
        <translation>均方根误差（mm）</translation>
    </message>
    <message>
        <source>roughness (mm)</source>
        <translation>粗糙度（mm）</translation>
    </message>
    <message>
        <source>energy (mJ)</source>
        <translation>能量（mJ）</translation>
    </message>
    <message>
        <source>%1 has no row: %2.</source>
        <translation>%1 没有对应行：%2。</translation>
    </message>
    <message>
        <source>Processing times</source>
        <translation>计算时间</translation>
    </message>
    <message>
        <source>unknowns</source>
        <translation>未知量</translation>
    </message>
    <message>
        <source>set-up (s)</source>
        <translation>准备（s）</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>帧数</translation>
    </message>
    <message>
        <source>The twist model alone, without its mesh, updates all key points in %1 microseconds.</source>
        <translation>仅扭转模型（不含网格）更新全部关键点需 %1 微秒。</translation>
    </message>
    <message>
        <source>Comparison of twist models</source>
        <translation>扭转模型比较</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>精度</translation>
    </message>
    <message>
        <source>What these figures do not say</source>
        <translation>这些数字没有说明的</translation>
    </message>
    <message>
        <source>The twist model computes in advance; finite elements of small strain could do so too (one answer to one newton metre, scaled), as fast, but would swell with the angle. The comparison is with elements that bear large rotations.</source>
        <translation>扭转模型预先计算；小应变有限元也可以这样做（对 1 N·m 求解一次再按比例缩放），速度相同，但会随角度增大而膨胀。此处比较的是能承受大转动的单元。</translation>
    </message>
    <message>
        <source>Set-up counts when organ or tissue change: it is stated apart and not in the deformation time.</source>
        <translation>更换器官或组织时需计入准备时间：单独列出，不计入形变时间。</translation>
    </message>
    <message>
        <source>Linear tetrahedra lock: they are too stiff in torsion, the more so the coarser and the less compressible. More of them, or quadratic ones, would be more accurate and slower. Springs by position-based dynamics are as stiff as their substeps make them; their error is read in the equilibrium of the springs themselves.</source>
        <translation>线性四面体会发生锁定：扭转时过硬，网格越粗、材料越不可压缩越明显。增加单元数或采用二次单元会更准确但更慢。基于位置动力学的弹簧刚度取决于子步数；其误差在弹簧自身的平衡状态下读取。</translation>
    </message>
    <message>
        <source>The end is turned as a rigid body in its place; the twist model lets it warp and slide. The reference shares material, ends and lattice with the elements and not with a person: only measurements say which model is near to life, and bones are in none of them.</source>
        <translation>端部在原位作为刚体转动；扭转模型则允许其翘曲和滑移。参考解的材料、端部条件和点阵与有限元相同，而非与真人相同：只有实测才能说明哪个模型更接近真实，且各模型均不含骨骼。</translation>
    </message>
    <message>
        <source>The torques of the twist model as printed in the paper come from a cone in place of the membrane, and its rotation is linear: both errors grow with the torque.</source>
        <translation>论文原式扭转模型的扭矩以圆锥代替薄膜求得，且其转动是线性的：两种误差均随扭矩增大。</translation>
    </message>
    <message>
        <source>Equilibrium of elements and springs</source>
        <translation>单元与弹簧的平衡</translation>
    </message>
    <message>
        <source>Twist model</source>
        <translation>扭转模型</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考解</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>正在写入</translation>
    </message>
    <message>
        <source>lies on the line from from_mm to to_mm</source>
        <translation>位于 from_mm 到 to_mm 的连线上</translation>
    </message>
    <message>
        <source>Choose landmarks at least a millimetre apart.</source>
        <translation>请选择相距至少一毫米的标志点。</translation>
    </message>
    <message>
        <source>is less than a millimetre from axis_from_mm</source>
        <translation>与 axis_from_mm 相距不足一毫米</translation>
    </message>
    <message>
        <source>Choose landmarks farther apart.</source>
        <translation>请选择相距更远的标志点。</translation>
    </message>
    <message>
        <source>is one point for several springs</source>
        <translation>只有一个点，却对应多根弹簧</translation>
    </message>
    <message>
        <source>Give &apos;side&apos; instead, or one spring.</source>
        <translation>请改用“side”，或只用一根弹簧。</translation>
    </message>
    <message>
        <source>%1, line %2, field &quot;%3&quot;</source>
        <translation>%1，第 %2 行，字段“%3”</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a finite number</source>
        <translation>“%1”不是有限的数</translation>
    </message>
    <message>
        <source>The file is no marker file of type 4 (X/Y/Z)</source>
        <translation>该文件不是第 4 类（X/Y/Z）标记点文件</translation>
    </message>
    <message>
        <source>Export the places of markers as TRC</source>
        <translation>请将标记点位置导出为 TRC 文件</translation>
    </message>
    <message>
        <source>The header lacks this field</source>
        <translation>文件头缺少该字段</translation>
    </message>
    <message>
        <source>A whole number from 1 on is needed</source>
        <translation>须为不小于 1 的整数</translation>
    </message>
    <message>
        <source>Export the file once more</source>
        <translation>请重新导出该文件</translation>
    </message>
    <message>
        <source>The rate must be positive</source>
        <translation>帧率必须为正数</translation>
    </message>
    <message>
        <source>Give frames a second, such as 100</source>
        <translation>请给出每秒帧数，例如 100</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no unit of length here</source>
        <translation>“%1”不是可用的长度单位</translation>
    </message>
    <message>
        <source>Use mm, cm or m</source>
        <translation>请使用 mm、cm 或 m</translation>
    </message>
    <message>
        <source>The line must begin with Frame# and Time</source>
        <translation>该行必须以 Frame# 和 Time 开头</translation>
    </message>
    <message>
        <source>The organ has no marker of this name</source>
        <translation>该器官没有此名称的标记点</translation>
    </message>
    <message>
        <source>Call it by its number or its name, or leave it out of the export</source>
        <translation>请用编号或名称称呼该标记点，或导出时不包含它</translation>
    </message>
    <message>
        <source>Marker %1 stands twice</source>
        <translation>标记点 %1 出现了两次</translation>
    </message>
    <message>
        <source>Leave one of them out</source>
        <translation>请去掉其中一个</translation>
    </message>
    <message>
        <source>Each marker has three columns X, Y, Z with its place in the line</source>
        <translation>每个标记点须有 X、Y、Z 三列，并带其序号</translation>
    </message>
    <message>
        <source>Times are seconds from 0 that rise from frame to frame</source>
        <translation>时间以秒计，从 0 起逐帧递增</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>参考解</translation>
    </message>
    <message>
        <source>PM as printed</source>
        <translation>PM（论文原式）</translation>
    </message>
    <message>
        <source>Finite elements and springs have mass and follow the torque late; the others are in equilibrium at once. What was measured goes by the name of the person.</source>
        <translation>有限元与弹簧具有质量，对扭矩的跟随有滞后；其余模型立即达到平衡。实测曲线以受测者的名称标示。</translation>
    </message>
    <message>
        <source>They stand in %1.</source>
        <translation>数值见 %1。</translation>
    </message>
    <message>
        <source>The torque must not be 0 and lie within 100 N m</source>
        <translation>扭矩不能为 0，且须在 ±100 N m 以内</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>扭矩</translation>
    </message>
    <message>
        <source>Give newton metres, such as 0.03</source>
        <translation>请以 N m 给出，例如 0.03</translation>
    </message>
    <message>
        <source>The torque must grow for 0.1 to 5 s</source>
        <translation>扭矩的增长时间须为 0.1 至 5 秒</translation>
    </message>
    <message>
        <source>growth of the torque</source>
        <translation>扭矩的增长</translation>
    </message>
    <message>
        <source>Give seconds, such as 1</source>
        <translation>请以秒给出，例如 1</translation>
    </message>
    <message>
        <source>Elements need 1 to 12 rings</source>
        <translation>单元须有 1 至 12 圈</translation>
    </message>
    <message>
        <source>rings</source>
        <translation>圈数</translation>
    </message>
    <message>
        <source>Give a whole number such as 4</source>
        <translation>请给出整数，例如 4</translation>
    </message>
    <message>
        <source>A frame of the springs needs 1 to 1000 substeps</source>
        <translation>弹簧模型每帧须有 1 至 1000 个子步</translation>
    </message>
    <message>
        <source>substeps</source>
        <translation>子步数</translation>
    </message>
    <message>
        <source>Give a whole number such as 10</source>
        <translation>请给出整数，例如 10</translation>
    </message>
    <message>
        <source>Reference (quadratic elements, neo-Hookean)</source>
        <translation>参考解（二次单元，neo-Hookean 材料）</translation>
    </message>
    <message>
        <source>FEM (corotational linear tetrahedra)</source>
        <translation>FEM（共旋线性四面体）</translation>
    </message>
    <message>
        <source>MSM (springs, XPBD)</source>
        <translation>MSM（弹簧，XPBD）</translation>
    </message>
    <message>
        <source>PM (twist model, Saint-Venant)</source>
        <translation>PM（扭转模型，Saint-Venant）</translation>
    </message>
    <message>
        <source>PM as printed (linear rotation, cone)</source>
        <translation>PM，论文原式（线性转动，锥体）</translation>
    </message>
    <message>
        <source>Times are seconds from 0 that rise from sample to sample of a marker</source>
        <translation>时间以秒计，从 0 起，同一标记点的样本逐个递增</translation>
    </message>
    <message>
        <source>Sort the rows by time and drop repeated ones</source>
        <translation>请按时间排序，并删除重复的行</translation>
    </message>
    <message>
        <source>Marker %1 of subject &apos;%2&apos; has one sample only</source>
        <translation>受测者“%2”的标记点 %1 只有一个样本</translation>
    </message>
    <message>
        <source>Give its place at rest and at least one later</source>
        <translation>请给出其静止位置和至少一个之后的位置</translation>
    </message>
    <message>
        <source>The file holds no measurements</source>
        <translation>文件中没有测量数据</translation>
    </message>
    <message>
        <source>Give at least two samples a marker</source>
        <translation>每个标记点请至少给出两个样本</translation>
    </message>
    <message>
        <source>This organ has no markers to compare measurements with</source>
        <translation>该器官没有可与测量对比的标记点</translation>
    </message>
    <message>
        <source>Choose an organ with markers, such as arm</source>
        <translation>请选择带标记点的器官，例如 arm（前臂）</translation>
    </message>
    <message>
        <source>%1, marker %2, field &quot;%3&quot;</source>
        <translation>%1，标记点 %2，字段“%3”</translation>
    </message>
    <message>
        <source>Three finite numbers are needed</source>
        <translation>须为三个有限的数</translation>
    </message>
    <message>
        <source>Give them as [x, y, z]</source>
        <translation>请写作 [x, y, z]</translation>
    </message>
    <message>
        <source>The organ has %1 faces, numbered from 0</source>
        <translation>该器官有 %1 个面片，从 0 起编号</translation>
    </message>
    <message>
        <source>Give the number of one of them</source>
        <translation>请给出其中一个的编号</translation>
    </message>
    <message>
        <source>A face alone is no point</source>
        <translation>仅有面片不能确定一点</translation>
    </message>
    <message>
        <source>Give three numbers that sum to 1</source>
        <translation>请给出和为 1 的三个数</translation>
    </message>
    <message>
        <source>The coordinates lie outside the face</source>
        <translation>坐标位于面片之外</translation>
    </message>
    <message>
        <source>Give three numbers from 0 to 1 that sum to 1</source>
        <translation>请给出三个 0 到 1 之间、和为 1 的数</translation>
    </message>
    <message>
        <source>The marker has no place</source>
        <translation>该标记点没有位置</translation>
    </message>
    <message>
        <source>Give face and barycentric, or position_mm</source>
        <translation>请给出 face 和 barycentric，或给出 position_mm</translation>
    </message>
    <message>
        <source>The place lies more than 5 mm from the organ&apos;s surface</source>
        <translation>该位置距器官表面超过 5 mm</translation>
    </message>
    <message>
        <source>Give a point of the surface, millimetres in the frame of the mesh</source>
        <translation>请给出表面上的一点，以毫米计，采用网格的坐标系</translation>
    </message>
    <message>
        <source>Markers are numbered 1, 2, 3 and so on</source>
        <translation>标记点按 1、2、3…… 编号</translation>
    </message>
    <message>
        <source>Number them in their order</source>
        <translation>请按顺序编号</translation>
    </message>
    <message>
        <source>The marker has no name</source>
        <translation>该标记点没有名称</translation>
    </message>
    <message>
        <source>Give a text</source>
        <translation>请给出文字</translation>
    </message>
    <message>
        <source>An organ has 1 to %1 markers, here are %2</source>
        <translation>一个器官可有 1 至 %1 个标记点，此处有 %2 个</translation>
    </message>
    <message>
        <source>Add or remove some</source>
        <translation>请增加或删除一些</translation>
    </message>
    <message>
        <source>Markers %1 and %2 have the same name</source>
        <translation>标记点 %1 与 %2 同名</translation>
    </message>
    <message>
        <source>Give each another name</source>
        <translation>请为每个标记点取不同的名称</translation>
    </message>
    <message>
        <source>Give a file as the window saves it (docs/validation.md)</source>
        <translation>请给出由窗口保存的文件（见 docs/validation.md）</translation>
    </message>
    <message>
        <source>The markers cannot be read: %1</source>
        <translation>无法读取标记点：%1</translation>
    </message>
    <message>
        <source>The file has no list &quot;markers&quot;</source>
        <translation>文件中没有 &quot;markers&quot; 列表</translation>
    </message>
    <message>
        <source>The markers were placed on another organ</source>
        <translation>这些标记点是在另一个器官上放置的</translation>
    </message>
    <message>
        <source>Choose the organ that they were saved with</source>
        <translation>请选择保存时所用的器官</translation>
    </message>
    <message>
        <source>The %1 values drawn are too many to print here.</source>
        <translation>图中共有 %1 个数值，无法在此全部印出。</translation>
    </message>
    <message>
        <source>The program shows them under Results.</source>
        <translation>程序在“结果”中显示这些数值。</translation>
    </message>
    <message>
        <source>The shear modulus must be positive and finite</source>
        <translation>剪切模量必须为有限的正数</translation>
    </message>
    <message>
        <source>shear modulus</source>
        <translation>剪切模量</translation>
    </message>
    <message>
        <source>Give it in pascal</source>
        <translation>请以帕为单位给出</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio must lie in [0, 0.5)</source>
        <translation>泊松比须在 [0, 0.5) 内</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio</source>
        <translation>泊松比</translation>
    </message>
    <message>
        <source>Give a number such as 0.45; 0.5 itself has no finite stiffness</source>
        <translation>请给出 0.45 之类的数；取 0.5 时刚度不是有限值</translation>
    </message>
    <message>
        <source>The torque must be finite</source>
        <translation>扭矩必须为有限的数</translation>
    </message>
    <message>
        <source>Give it in newton metres</source>
        <translation>请以 N m 为单位给出</translation>
    </message>
    <message>
        <source>An element of the organ is folded at rest</source>
        <translation>器官的一个单元在静止时已翻折</translation>
    </message>
    <message>
        <source>element %1</source>
        <translation>单元 %1</translation>
    </message>
    <message>
        <source>Give other ends, or fewer sections</source>
        <translation>请更换两端，或减少截面数</translation>
    </message>
    <message>
        <source>Springs are calibrated by a displacement that holds energy</source>
        <translation>弹簧须用储有能量的位移来标定</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>Give a torque that is not 0</source>
        <translation>请给出不为 0 的扭矩</translation>
    </message>
    <message>
        <source>A solid needs at least 2 sections</source>
        <translation>实体至少需要 2 个截面</translation>
    </message>
    <message>
        <source>Give 2 or more</source>
        <translation>请给出 2 或更大的数</translation>
    </message>
    <message>
        <source>A solid needs at least 1 ring</source>
        <translation>实体至少需要 1 圈</translation>
    </message>
    <message>
        <source>Give 1 or more</source>
        <translation>请给出 1 或更大的数</translation>
    </message>
    <message>
        <source>An outline needs at least 3 points</source>
        <translation>轮廓至少需要 3 个点</translation>
    </message>
    <message>
        <source>Give 3 or more</source>
        <translation>请给出 3 或更大的数</translation>
    </message>
    <message>
        <source>The solid would have more than 200000 points</source>
        <translation>实体的点数将超过 200000</translation>
    </message>
    <message>
        <source>Give fewer ridges, sections or rings</source>
        <translation>请减少脊线、截面或圈数</translation>
    </message>
    <message>
        <source>The outlines have different numbers of points</source>
        <translation>各轮廓的点数不同</translation>
    </message>
    <message>
        <source>Give each section as many points as the first</source>
        <translation>请使每个截面的点数与第一个相同</translation>
    </message>
    <message>
        <source>A coordinate is not a finite number</source>
        <translation>有坐标不是有限的数</translation>
    </message>
    <message>
        <source>Give finite coordinates in metres</source>
        <translation>请以米为单位给出有限的坐标</translation>
    </message>
    <message>
        <source>The organ cannot be filled with elements: an outline is not star-shaped about its centre, or two sections cross</source>
        <translation>无法用单元填充该器官：有轮廓关于其中心不是星形，或有两个截面相交</translation>
    </message>
    <message>
        <source>Quadratic elements reach over two ridges, two rings and two sections</source>
        <translation>二次单元跨两条脊线、两圈和两个截面</translation>
    </message>
    <message>
        <source>lattice</source>
        <translation>网格线</translation>
    </message>
    <message>
        <source>Give an even number of ridges and rings and an odd number of sections</source>
        <translation>请使脊线数和圈数为偶数，截面数为奇数</translation>
    </message>
    <message>
        <source>A frame needs at least 1 substep</source>
        <translation>每帧至少需要 1 个子步</translation>
    </message>
    <message>
        <source>Give 10 or more</source>
        <translation>请给出 10 或更大的数</translation>
    </message>
    <message>
        <source>Poynting&apos;s stretch</source>
        <translation>Poynting 轴向伸长</translation>
    </message>
    <message>
        <source>restrained ends</source>
        <translation>端部约束</translation>
    </message>
    <message>
        <source>taper</source>
        <translation>锥度</translation>
    </message>
    <message>
        <source>shear centre</source>
        <translation>剪切中心</translation>
    </message>
    <message>
        <source>foundation</source>
        <translation>弹性地基</translation>
    </message>
    <message>
        <source>stiffening</source>
        <translation>硬化</translation>
    </message>
    <message>
        <source>the paper&apos;s formulation does not know this</source>
        <translation>论文公式没有这一项</translation>
    </message>
    <message>
        <source>Leave it out, or choose the formulation saint-venant</source>
        <translation>请去掉它，或选择 saint-venant 公式</translation>
    </message>
    <message>
        <source>interpolation (Eq. 15)</source>
        <translation>插值（式 15）</translation>
    </message>
    <message>
        <source>beta (Eq. 18)</source>
        <translation>β（式 18）</translation>
    </message>
    <message>
        <source>clamp lift (Eq. 23)</source>
        <translation>夹持端抬升（式 23）</translation>
    </message>
    <message>
        <source>only the paper&apos;s formulation knows this</source>
        <translation>只有论文公式有这一项</translation>
    </message>
    <message>
        <source>Leave it out, or choose the formulation paper</source>
        <translation>请去掉它，或选择 paper 公式</translation>
    </message>
    <message>
        <source>beta of Eq. 18 must be a number, and not 0</source>
        <translation>式 18 的 β 必须是数，且不为 0</translation>
    </message>
    <message>
        <source>Give a number of sections, or leave it out</source>
        <translation>请给出截面数，或不填</translation>
    </message>
    <message>
        <source>markers (mm)</source>
        <translation>标记点（mm）</translation>
    </message>
    <message>
        <source>course (mm)</source>
        <translation>曲线（mm）</translation>
    </message>
    <message>
        <source>radius (%)</source>
        <translation>半径（%）</translation>
    </message>
    <message>
        <source>volume (%)</source>
        <translation>体积（%）</translation>
    </message>
    <message>
        <source>RMSE: over all key points of the lattice; markers and course: of their displacements. Radius: its largest change. Roughness: what the radius of a key point changes differently from its four neighbours.</source>
        <translation>RMSE：对点阵的全部关键点计算；标记点与曲线：对其位移计算。半径：其最大变化。粗糙度：关键点半径变化与其四个相邻点之差。</translation>
    </message>
    <message>
        <source>frame (ms)</source>
        <translation>每帧（ms）</translation>
    </message>
    <message>
        <source>worst (ms)</source>
        <translation>最慢帧（ms）</translation>
    </message>
    <message>
        <source>twist (s)</source>
        <translation>扭转（s）</translation>
    </message>
    <message>
        <source>settling (s)</source>
        <translation>趋衡（s）</translation>
    </message>
    <message>
        <source>last angle (deg)</source>
        <translation>末帧角（°）</translation>
    </message>
    <message>
        <source>Frame: the median. Settling: from the last frame to equilibrium, no part of the twist. Last angle: as the last frame showed it.</source>
        <translation>每帧：中位数。趋衡：从最后一帧到平衡，不计入扭转用时。末帧角：最后一帧显示的角度。</translation>
    </message>
    <message>
        <source>The grasp must lie in (0, 1], as a fraction of the organ&apos;s length</source>
        <translation>夹持位置须在 (0, 1] 之内，以器官长度的比例表示</translation>
    </message>
    <message>
        <source>grasp</source>
        <translation>夹持位置</translation>
    </message>
    <message>
        <source>Give a fraction such as 0.8</source>
        <translation>请给出一个比例，例如 0.8</translation>
    </message>
    <message>
        <source>Rod (ticks of the simulator, and its skin)</source>
        <translation>弯杆（模拟器的时间步及其表面）</translation>
    </message>
    <message>
        <source>No equilibrium was found</source>
        <translation>未找到平衡状态</translation>
    </message>
    <message>
        <source>Turn less far, or in more steps</source>
        <translation>请少转一些，或分更多步</translation>
    </message>
    <message>
        <source>there is no recording of this model</source>
        <translation>该模型没有录制</translation>
    </message>
    <message>
        <source>Score what you have met</source>
        <translation>请按您已接触到的情况评分</translation>
    </message>
    <message>
        <source>a model has no recording</source>
        <translation>有一个模型没有录制</translation>
    </message>
    <message>
        <source>Choose one for each model, or for none</source>
        <translation>请为每个模型各选一份，或都不选</translation>
    </message>
    <message>
        <source>this recording has no end</source>
        <translation>该录制没有结尾</translation>
    </message>
    <message>
        <source>Choose a finished one</source>
        <translation>请选择已完成的录制</translation>
    </message>
    <message>
        <source>this recording belongs to a trainee</source>
        <translation>该录制属于一位学员</translation>
    </message>
    <message>
        <source>Choose one of free practice</source>
        <translation>请选择自由练习的录制</translation>
    </message>
    <message>
        <source>two recordings were made with the same model</source>
        <translation>有两份录制是用同一模型录制的</translation>
    </message>
    <message>
        <source>Choose one of each model</source>
        <translation>请每个模型选一份</translation>
    </message>
    <message>
        <source>there is no model &apos;%1&apos;</source>
        <translation>没有模型“%1”</translation>
    </message>
    <message>
        <source>the model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>this task turns the other way</source>
        <translation>该任务的扭转方向与此相反</translation>
    </message>
    <message>
        <source>--angle %1, target %2</source>
        <translation>--angle %1，目标 %2</translation>
    </message>
    <message>
        <source>is not known to the formulation &apos;paper&apos;</source>
        <translation>不适用于 paper 公式</translation>
    </message>
    <message>
        <source>is known to the formulation &apos;paper&apos; only</source>
        <translation>仅适用于 paper 公式</translation>
    </message>
    <message>
        <source>is 0</source>
        <translation>为 0</translation>
    </message>
    <message>
        <source>Give an angle with the sign of the target</source>
        <translation>请给出与目标同号的角度</translation>
    </message>
    <message>
        <source>the values are too large to be squared</source>
        <translation>数值过大，无法求平方</translation>
    </message>
    <message>
        <source>there are more than %1 distinct values to compare in each resample</source>
        <translation>每次重抽样需比较的不同数值超过 %1 个</translation>
    </message>
    <message>
        <source>arm &quot;%1&quot; is named twice</source>
        <translation>组别“%1”重复出现</translation>
    </message>
    <message>
        <source>Name each arm once.</source>
        <translation>每个组别只列一次。</translation>
    </message>
    <message>
        <source>blocks of %1 and %2 cannot fill a stratum without a rest</source>
        <translation>大小为 %1 和 %2 的区组无法恰好填满一个分层</translation>
    </message>
    <message>
        <source>the record of this station is gone</source>
        <translation>本工作站的记录已不存在</translation>
    </message>
    <message>
        <source>Connect the disk that it lies on, or restore the latest backup</source>
        <translation>请连接存放它的磁盘，或恢复最近的备份</translation>
    </message>
    <message>
        <source>the record of this station holds no centre any more</source>
        <translation>本工作站的记录中已没有任何中心</translation>
    </message>
    <message>
        <source>is a record with real people or data</source>
        <translation>是含有真实人员或数据的记录</translation>
    </message>
    <message>
        <source>may be a record with real people: %1</source>
        <translation>可能是含有真实人员的记录：%1</translation>
    </message>
    <message>
        <source>Give the demonstration a folder of its own; this file was not touched</source>
        <translation>请为演示另指定一个文件夹；此文件未被改动</translation>
    </message>
    <message>
        <source>Other accounts of this computer could read %1; now only yours can</source>
        <translation>此前本机其他账户可以读取 %1；现在只有您的账户可以读取</translation>
    </message>
    <message>
        <source>staff or student number</source>
        <translation>工号或学号</translation>
    </message>
    <message>
        <source>e-mail</source>
        <translation>电子邮箱</translation>
    </message>
    <message>
        <source>this text %1</source>
        <translation>此文本%1</translation>
    </message>
    <message>
        <source>Type it anew</source>
        <translation>请重新输入</translation>
    </message>
    <message>
        <source>is longer than %1 characters</source>
        <translation>超过 %1 个字符</translation>
    </message>
    <message>
        <source>holds the character U+%1, which nobody can see</source>
        <translation>含有不可见字符 U+%1</translation>
    </message>
    <message>
        <source>is larger than %1 MiB, which no roster is</source>
        <translation>大于 %1 MiB，名册不会有这么大</translation>
    </message>
    <message>
        <source>Choose the list of the people, or divide it</source>
        <translation>请选择人员名单，或将其拆分</translation>
    </message>
    <message>
        <source>the number %1 looks like that of line %2, but is another</source>
        <translation>号码 %1 与第 %2 行的号码看起来相同，但并不是同一个</translation>
    </message>
    <message>
        <source>Write both in the same way, or change one of the two</source>
        <translation>请将两者写成一致，或更改其中一个</translation>
    </message>
    <message>
        <source>Type the cell anew</source>
        <translation>请重新输入该单元格</translation>
    </message>
    <message>
        <source>the number %1 looks like that of %2, but is another</source>
        <translation>号码 %1 与 %2 的号码看起来相同，但并不是同一个</translation>
    </message>
    <message>
        <source>Write it as in the record, or change one of the two</source>
        <translation>请写成与记录中一致，或更改其中一个</translation>
    </message>
    <message>
        <source>is no file, so it is no database</source>
        <translation>不是文件，因此也不是数据库</translation>
    </message>
    <message>
        <source>Name a file</source>
        <translation>请指定一个文件</translation>
    </message>
    <message>
        <source>is empty, which no record ever is: something emptied it</source>
        <translation>是空文件，而记录绝不会为空：内容已被清除</translation>
    </message>
    <message>
        <source>Restore the latest backup; if there never was a record here, remove the file</source>
        <translation>请恢复最近的备份；如果此处从未有过记录，请删除该文件</translation>
    </message>
    <message>
        <source>is no backup, so it is never replaced by one</source>
        <translation>不是备份，因此绝不会被备份替换</translation>
    </message>
    <message>
        <source>Name another file</source>
        <translation>请指定其他文件</translation>
    </message>
    <message>
        <source>exists already</source>
        <translation>已存在</translation>
    </message>
    <message>
        <source>Name another file, or give --replace</source>
        <translation>请指定其他文件，或使用 --replace</translation>
    </message>
    <message>
        <source>another program is writing this file now</source>
        <translation>另一个程序正在写入此文件</translation>
    </message>
    <message>
        <source>Wait until it has come to its end</source>
        <translation>请等待其结束</translation>
    </message>
    <message>
        <source>is a database, which is never overwritten</source>
        <translation>是数据库，绝不会被覆盖</translation>
    </message>
    <message>
        <source>is no key of Torsio</source>
        <translation>不是 Torsio 的密钥</translation>
    </message>
    <message>
        <source>Make one with torsio audit key FILE</source>
        <translation>请用 torsio audit key FILE 生成</translation>
    </message>
    <message>
        <source>other accounts of this computer could read this key until now</source>
        <translation>此前本机其他账户可以读取此密钥</translation>
    </message>
    <message>
        <source>Make a new key, and keep this one only to check older heads</source>
        <translation>请生成新密钥，此密钥仅保留用于核对较早的链头</translation>
    </message>
    <message>
        <source>is no head of an audit trail</source>
        <translation>不是审计记录的链头</translation>
    </message>
    <message>
        <source>Give a line that torsio audit head printed</source>
        <translation>请提供 torsio audit head 输出的一行</translation>
    </message>
    <message>
        <source>Name a new file: an older key is needed to check older heads</source>
        <translation>请指定新文件：核对较早的链头需要旧密钥</translation>
    </message>
    <message>
        <source>holds no head of an audit trail</source>
        <translation>不含审计记录的链头</translation>
    </message>
    <message>
        <source>Choose the file that torsio audit head --witness wrote</source>
        <translation>请选择 torsio audit head --witness 写入的文件</translation>
    </message>
    <message>
        <source>seals a row otherwise that was sealed before</source>
        <translation>对先前已封存的行作了不同的封存</translation>
    </message>
    <message>
        <source>the library&apos;s servo stopped calling after %1 s</source>
        <translation>%1 秒后厂商库的伺服停止了调用</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Calibrate the device again; if it stays so, have it serviced</source>
        <translation>请重新校准设备；若仍如此，请送修</translation>
    </message>
    <message>
        <source>the position stands still while the stylus is turned</source>
        <translation>转动手柄笔时位置保持不动</translation>
    </message>
    <message>
        <source>the library&apos;s servo loop stopped calling</source>
        <translation>厂商库的伺服循环停止了调用</translation>
    </message>
    <message>
        <source>the device is still being let go</source>
        <translation>设备仍在释放中</translation>
    </message>
    <message>
        <source>Wait a moment and try again; if it stays so, plug the device in again and restart Torsio</source>
        <translation>请稍候再试；若仍如此，请重新插入设备并重启 Torsio</translation>
    </message>
    <message>
        <source>the system gives no memory for the device process</source>
        <translation>系统未能为设备进程提供内存</translation>
    </message>
    <message>
        <source>the device process %1 cannot be started: %2</source>
        <translation>无法启动设备进程 %1：%2</translation>
    </message>
    <message>
        <source>Install Torsio anew; torsio-device lies beside the program</source>
        <translation>请重新安装 Torsio；torsio-device 位于程序所在的文件夹中</translation>
    </message>
    <message>
        <source>Plug the device in again, run the vendor&apos;s set-up tool once and try again</source>
        <translation>请重新插入设备，运行一次厂商的设置工具，然后再试</translation>
    </message>
    <message>
        <source>Give multiples of the smallest block.</source>
        <translation>请给出最小区组的整数倍。</translation>
    </message>
    <message>
        <source>the record in this database holds no centre</source>
        <translation>该数据库中的记录不含任何中心</translation>
    </message>
    <message>
        <source>Set the centre up at the first station; this one can join then</source>
        <translation>请先在第一台工作站建立中心；之后本工作站即可加入</translation>
    </message>
    <message>
        <source>the limits of the exercise are not known</source>
        <translation>不知道该练习的限值</translation>
    </message>
    <message>
        <source>the organ did not come twisted</source>
        <translation>器官起初并未扭转</translation>
    </message>
    <message>
        <source>the hand never turned the organ by 15 degrees</source>
        <translation>手从未将器官转动 15 度</translation>
    </message>
    <message>
        <source>nothing can be let out of this organ</source>
        <translation>该器官无内容物可排出</translation>
    </message>
    <message>
        <source>blood did not come back for 5 s before the recording ended</source>
        <translation>直到记录结束，血流都未恢复满 5 秒</translation>
    </message>
    <message>
        <source>the hand never held the organ</source>
        <translation>手从未夹住器官</translation>
    </message>
    <message>
        <source>the stress of the wall needs the scene at hand</source>
        <translation>壁的应力需要载入场景才能得出</translation>
    </message>
    <message>
        <source>the organ was never undone</source>
        <translation>器官从未复位</translation>
    </message>
    <message>
        <source>the organ was still held when the recording ended</source>
        <translation>记录结束时器官仍被夹住</translation>
    </message>
    <message>
        <source>the recording ended too soon after the organ was let go</source>
        <translation>松开器官后记录结束得太早</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Untwistings by group and phase</source>
        <translation>按组和阶段列出的扭转复位</translation>
    </message>
    <message>
        <source>Undone</source>
        <translation>已复位</translation>
    </message>
    <message>
        <source>Relapsed</source>
        <translation>复发</translation>
    </message>
    <message>
        <source>First turn the right way</source>
        <translation>首次转动方向正确</translation>
    </message>
    <message>
        <source>Blood came back</source>
        <translation>血流恢复</translation>
    </message>
    <message>
        <source>Median time until then (s)</source>
        <translation>至此的时间中位数（秒）</translation>
    </message>
    <message>
        <source>Median ischaemic dose</source>
        <translation>缺血剂量中位数</translation>
    </message>
    <message>
        <source>Median re-grips beyond the least number</source>
        <translation>超出最少次数的重新夹持中位数</translation>
    </message>
    <message>
        <source>Median slip back (deg)</source>
        <translation>回滑中位数（度）</translation>
    </message>
    <message>
        <source>is neither a number nor a list of pairs</source>
        <translation>既不是数字，也不是数对列表</translation>
    </message>
    <message>
        <source>Write 3, or [[0, 2], [1, 5]]: shares of the length, ascending, and millimetres.</source>
        <translation>写作 3，或 [[0, 2], [1, 5]]：递增的长度比例与毫米数。</translation>
    </message>
    <message>
        <source>Write one or two pairs [held, mobile] of shares of the length, such as [[0, 0.4], [1, 0.6]].</source>
        <translation>写一对或两对长度比例 [固定端, 活动端]，例如 [[0, 0.4], [1, 0.6]]。</translation>
    </message>
    <message>
        <source>must list one or two pairs</source>
        <translation>必须列出一对或两对</translation>
    </message>
    <message>
        <source>has a stretch that is too short or beyond the organ</source>
        <translation>有一段过短或超出器官</translation>
    </message>
    <message>
        <source>has two stretches without a mobile part between them</source>
        <translation>两段之间没有活动部分</translation>
    </message>
    <message>
        <source>and &apos;cord_stiffness_nmm_per_rad&apos; exclude each other, and one is needed</source>
        <translation>与 &apos;cord_stiffness_nmm_per_rad&apos; 互斥，且必须有其一</translation>
    </message>
    <message>
        <source>Give the wall of a hollow organ, or the stiffness of a solid cord.</source>
        <translation>请给出空腔器官的壁，或实心索的刚度。</translation>
    </message>
    <message>
        <source>belongs to the goal &apos;detorse&apos;, and that goal needs it</source>
        <translation>属于目标 &apos;detorse&apos;，且该目标需要它</translation>
    </message>
    <message>
        <source>Give both, or leave out both.</source>
        <translation>请两者都给出，或都省略。</translation>
    </message>
    <message>
        <source>the pattern grips the organ where it is wrung</source>
        <translation>该扭转类型夹持在器官被绞扭的部位</translation>
    </message>
    <message>
        <source>field &apos;grasp&apos;</source>
        <translation>字段 &apos;grasp&apos;</translation>
    </message>
    <message>
        <source>Grip between the mobile ends of the spans.</source>
        <translation>请夹持在各段活动端之间。</translation>
    </message>
    <message>
        <source>the pattern &apos;%1&apos; is undone, which only the twist model with a wall knows</source>
        <translation>扭转类型“%1”须复位，只有带壁的扭转模型支持</translation>
    </message>
    <message>
        <source>Choose another pattern, or leave out the other model.</source>
        <translation>请选择另一扭转类型，或去掉另一模型。</translation>
    </message>
    <message>
        <source>does not belong to an organ that is undone</source>
        <translation>不适用于须复位的器官</translation>
    </message>
    <message>
        <source>Leave out &apos;task&apos; and give &apos;angle_deg&apos; 0.</source>
        <translation>请省略 &apos;task&apos;，并将 &apos;angle_deg&apos; 设为 0。</translation>
    </message>
    <message>
        <source>Small-bowel loop, twisted</source>
        <translation>小肠袢扭转</translation>
    </message>
    <message>
        <source>Stomach, organo-axial volvulus</source>
        <translation>胃器官轴型扭转</translation>
    </message>
    <message>
        <source>Stomach, mesentero-axial volvulus</source>
        <translation>胃系膜轴型扭转</translation>
    </message>
    <message>
        <source>Testis on its cord, torsion</source>
        <translation>睾丸扭转</translation>
    </message>
    <message>
        <source>Sigmoid volvulus</source>
        <translation>乙状结肠扭转</translation>
    </message>
    <message>
        <source>Midgut volvulus</source>
        <translation>中肠扭转</translation>
    </message>
    <message>
        <source>Midgut: undo it</source>
        <translation>中肠：复位</translation>
    </message>
    <message>
        <source>Midgut: undo it, graded</source>
        <translation>中肠：复位，计分</translation>
    </message>
    <message>
        <source>Sigmoid: undo it</source>
        <translation>乙状结肠：复位</translation>
    </message>
    <message>
        <source>Sigmoid: undo it, graded</source>
        <translation>乙状结肠：复位，计分</translation>
    </message>
    <message>
        <source>Six organs that come twisted: small-bowel loop, stomach about its long axis, testis, sigmoid, stomach about its short axis, midgut. First find out which way it is twisted: the torque rises and the colour darkens when you turn the wrong way. Let gas out where you can, hold the organ while you grip anew, and turn on until it stays open and supplied with your hands off. The clock of the tissue runs sixty times faster than yours.</source>
        <translation>六个送来时已扭转的器官：小肠袢、绕长轴扭转的胃、睾丸、乙状结肠、绕短轴扭转的胃、中肠。先弄清扭转方向：方向转错时力矩增大、颜色变深。能排气的先排气；换手时固定器官；一直复位到松手后管腔仍通畅、血流仍恢复为止。组织的时钟比您的快六十倍。</translation>
    </message>
    <message>
        <source>Small-bowel loop: undo it</source>
        <translation>小肠袢：复位</translation>
    </message>
    <message>
        <source>Small-bowel loop: undo it, graded</source>
        <translation>小肠袢：复位，计分</translation>
    </message>
    <message>
        <source>Stomach, mesentero-axial: undo it</source>
        <translation>胃系膜轴型扭转：复位</translation>
    </message>
    <message>
        <source>Stomach, mesentero-axial: undo it, graded</source>
        <translation>胃系膜轴型扭转：复位，计分</translation>
    </message>
    <message>
        <source>Stomach, organo-axial: undo it</source>
        <translation>胃器官轴型扭转：复位</translation>
    </message>
    <message>
        <source>Stomach, organo-axial: undo it, graded</source>
        <translation>胃器官轴型扭转：复位，计分</translation>
    </message>
    <message>
        <source>Testis: undo it</source>
        <translation>睾丸：复位</translation>
    </message>
    <message>
        <source>Testis: undo it, graded</source>
        <translation>睾丸：复位，计分</translation>
    </message>
    <message>
        <source>Volvulus and torsion: undo it</source>
        <translation>肠胃扭转与睾丸扭转：复位</translation>
    </message>
    <message>
        <source>A loop of small bowel is twisted by half a turn to a whole one, either way. Find out which: turned the wrong way, the torque rises and the bowel darkens. Surgeons turn the loop back gently, let it rest under warm cloths and look for colour, pulse and movement before they judge it. Hard jaws bruise ischaemic bowel at half the pressure.</source>
        <translation>一段小肠袢扭转半圈至一整圈，方向不定。先查明方向：转错时力矩增大、肠管变暗。外科医生轻柔地把肠袢转回，用温盐水纱布敷一会儿，看颜色、搏动和蠕动后再判断。缺血的肠管只要一半的压力就会被钳伤。</translation>
    </message>
    <message>
        <source>The antrum lies twisted above the cardia by a quarter to half a turn, mostly not shut. Surgeons let the gas out, draw the antrum down and turn it back, usually in one grip. Watch the passage: it must stay open with your hands off. Pulling at the antrum tears it.</source>
        <translation>胃窦扭转四分之一到半圈，位于贲门上方，多未完全闭塞。外科医生先排气，把胃窦拉下并转回，通常一次握持即可。注意通道：松手后必须保持通畅。牵拉胃窦会使其撕裂。</translation>
    </message>
    <message>
        <source>The sigmoid loop is twisted by half a turn to a whole one on its narrow root and blown up. Let the gas out through the scope first: it takes most of the torque away. Turn the top back, clip it when you grip anew, and stay: it comes back in nearly half of the patients. Black mucosa or a tear means resection, not turning.</source>
        <translation>乙状结肠袢在狭窄的根部扭转半圈至一整圈，并且胀气。先经肠镜排气，可去掉大部分力矩。把肠袢顶部转回，换手时夹住，并守住：近一半患者会复发。黏膜发黑或破裂时应切除，而不是复位。</translation>
    </message>
    <message>
        <source>The stomach is turned over by half a turn or more and shut at both ends. Surgeons first let the gas out through a tube, then turn the greater curvature back down; a full stomach resists with more than twice the torque. Hold it with the clip while you grip anew: let go beyond a quarter turn, it rolls back. Pulling tears the wall.</source>
        <translation>胃翻转半圈以上，两端闭塞。外科医生先经胃管排气，再把胃大弯转回原位；胀满的胃阻力大一倍以上。换手时用夹固定：在四分之一圈以外松手，胃会转回去。牵拉会撕裂胃壁。</translation>
    </message>
    <message>
        <source>The whole small bowel is twisted clockwise by one to two turns on the stalk of its vessels. Turn back the hands of time: counter-clockwise, often by more than one turn. Take the whole pack, clip it between the grips, and turn until the bowel is pink and its vessels beat. Every minute counts: it is starved from one turn on.</source>
        <translation>全部小肠绕血管蒂顺时针扭转一到两圈。把时钟拨回去：逆时针转，常要超过一圈。握住整团肠管，换手之间用夹固定，直到肠管转红、血管搏动。分秒必争：扭转一圈起就已缺血。</translation>
    </message>
    <message>
        <source>Scheduling</source>
        <translation>调度</translation>
    </message>
    <message>
        <source>the servo goes before other work and stays in memory</source>
        <translation>伺服优先于其他工作并常驻内存</translation>
    </message>
    <message>
        <source>the system refuses real-time priority</source>
        <translation>系统拒绝实时优先级</translation>
    </message>
    <message>
        <source>the system refuses to keep the servo in memory</source>
        <translation>系统拒绝让伺服常驻内存</translation>
    </message>
    <message>
        <source>the system refuses real-time priority and to keep the servo in memory</source>
        <translation>系统拒绝实时优先级，也拒绝让伺服常驻内存</translation>
    </message>
    <message>
        <source>%1; the servo kept its time all the same</source>
        <translation>%1；伺服仍然准时</translation>
    </message>
    <message>
        <source>Copy assets/system/torsio-limits.conf to /etc/security/limits.d and log in again</source>
        <translation>将 assets/system/torsio-limits.conf 复制到 /etc/security/limits.d 并重新登录</translation>
    </message>
    <message>
        <source>stored energy of the force</source>
        <translation>力的储能</translation>
    </message>
    <message>
        <source>The period lies above zero, the latency in 0..16 ticks</source>
        <translation>周期须大于零，延迟须在 0 至 16 个节拍之间</translation>
    </message>
    <message>
        <source>Driver</source>
        <translation>驱动程序</translation>
    </message>
    <message>
        <source>this device gives no force: it is shown, not felt</source>
        <translation>此设备不提供力：力只显示，感觉不到</translation>
    </message>
    <message>
        <source>Measures of force are marked in every run with it</source>
        <translation>用它进行的每次操作中，力的测量值都会加以标注</translation>
    </message>
    <message>
        <source>the device needs none</source>
        <translation>此设备无需校准</translation>
    </message>
    <message>
        <source>Close other programs</source>
        <translation>请关闭其他程序</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no device that is plugged in</source>
        <translation>“%1”不是可插接的设备</translation>
    </message>
    <message>
        <source>`torsio device list` shows the others</source>
        <translation>`torsio device list` 会列出其他设备</translation>
    </message>
    <message>
        <source>no game controller could be opened</source>
        <translation>无法打开任何游戏手柄</translation>
    </message>
    <message>
        <source>game controller</source>
        <translation>游戏手柄</translation>
    </message>
    <message>
        <source>Plug it in or pair it, and give the user access to /dev/input (docs/devices.md)</source>
        <translation>请插上或配对手柄，并授予用户访问 /dev/input 的权限（docs/devices.md）</translation>
    </message>
    <message>
        <source>this kind of device was not confirmed on hardware yet</source>
        <translation>此类设备尚未在真实硬件上确认</translation>
    </message>
    <message>
        <source>found: %1</source>
        <translation>已找到：%1</translation>
    </message>
    <message>
        <source>no game controller is connected</source>
        <translation>未连接游戏手柄</translation>
    </message>
    <message>
        <source>no game controller is called &quot;%1&quot;</source>
        <translation>没有名为“%1”的游戏手柄</translation>
    </message>
    <message>
        <source>Choose one of: %1</source>
        <translation>请从以下选项中选择：%1</translation>
    </message>
    <message>
        <source>a controller that SDL knows; not confirmed on hardware</source>
        <translation>SDL 认识的手柄；尚未在硬件上确认</translation>
    </message>
    <message>
        <source>there is no device driver &quot;%1&quot;</source>
        <translation>没有名为“%1”的设备驱动程序</translation>
    </message>
    <message>
        <source>the vendor&apos;s driver and OpenHaptics</source>
        <translation>厂商的驱动程序和 OpenHaptics</translation>
    </message>
    <message>
        <source>the daemon spacenavd does not answer</source>
        <translation>守护进程 spacenavd 没有应答</translation>
    </message>
    <message>
        <source>Install spacenavd, start it and plug the device in (docs/devices.md)</source>
        <translation>请安装并启动 spacenavd，然后插上设备（docs/devices.md）</translation>
    </message>
    <message>
        <source>spacenavd runs, but has no device</source>
        <translation>spacenavd 正在运行，但没有设备</translation>
    </message>
    <message>
        <source>in use by this program</source>
        <translation>本程序正在使用</translation>
    </message>
    <message>
        <source>the daemon spacenavd; not confirmed on hardware</source>
        <translation>守护进程 spacenavd；尚未在硬件上确认</translation>
    </message>
    <message>
        <source>the daemon spacenavd does not exist on this system</source>
        <translation>此系统上没有守护进程 spacenavd</translation>
    </message>
    <message>
        <source>Use another device</source>
        <translation>请使用其他设备</translation>
    </message>
    <message>
        <source>no handle is connected: the jaw cannot be turned or closed</source>
        <translation>未连接手柄：钳口无法转动或闭合</translation>
    </message>
    <message>
        <source>Install the device&apos;s service and start it (docs/devices.md)</source>
        <translation>请安装并启动设备的服务（docs/devices.md）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not of the form HOST:PORT</source>
        <translation>“%1”不是“主机:端口”的形式</translation>
    </message>
    <message>
        <source>Correct the variable, or unset it</source>
        <translation>请更正或清除该变量</translation>
    </message>
    <message>
        <source>the service runs, but has no such device</source>
        <translation>服务正在运行，但没有这样的设备</translation>
    </message>
    <message>
        <source>the device&apos;s service on this computer; not confirmed on hardware</source>
        <translation>本机上的设备服务；尚未在硬件上确认</translation>
    </message>
    <message>
        <source>no service answers at %1</source>
        <translation>%1 上没有服务应答</translation>
    </message>
    <message>
        <source>A stomach that is held at the cardia; antrum and pylorus are in the hand and turn on the body. In a patient the antrum swings up about the short axis through the middle of both curvatures and the body kinks; the model has no such hinge: it turns the antrum about the stomach&apos;s own axis and wrings the body between cardia and antrum, with the same order of steps and the same blood. The law of the wall was checked for length over radius 3 to 12 and wall over radius 0.03 to 0.1. The body is 124 mm long on a mean radius of 34 mm (3.6) with a wall over radius of 0.05 to 0.07: inside. Pressure times radius over stiffness times wall is 2.8 at 6 mmHg, held against a second computation up to 0.5 only. The lumen shuts near 150 degrees. Thickness and the pressure of a fasted stomach are sourced; the pressure of the volvulus, the stiffness of the wall, friction and vessels are assumed. Blood flow against the angle was measured on testes only and is carried over. Colour is no proof of life. For training the hand and the order of steps; it says nothing about one patient.</source>
        <translation>胃固定在贲门；胃窦和幽门握在手中，相对胃体转动。在患者体内，胃窦绕穿过大小弯中点的短轴向上翻起，胃体折叠；模型没有这样的铰链：它让胃窦绕胃自身的轴线转动，拧转贲门与胃窦之间的胃体，步骤顺序和血流变化相同。管壁定律在长度与半径之比 3 至 12、壁厚与半径之比 0.03 至 0.1 的范围内验证过。胃体长 124 mm，平均半径 34 mm（比值 3.6），壁厚与半径之比为 0.05 至 0.07：在范围之内。6 mmHg 时压力乘半径除以刚度与壁厚之积为 2.8，而与另一种计算的对照只做到 0.5。胃腔在约 150 度时闭合。壁厚和空腹时的胃内压有文献来源；扭转时的压力、管壁刚度、摩擦和血管为假设值。血流与扭转角的关系只在睾丸上测量过，此处借用。颜色不能证明组织存活。仅用于训练手法和步骤顺序，不能用于判断具体患者。</translation>
    </message>
    <message>
        <source>Combined, 120 degrees</source>
        <translation>复合型 120 度</translation>
    </message>
    <message>
        <source>Loop, 180 degrees</source>
        <translation>肠袢 180 度</translation>
    </message>
    <message>
        <source>Mesentero-axial, 45 degrees</source>
        <translation>系膜轴型 45 度</translation>
    </message>
    <message>
        <source>Organo-axial, 180 degrees</source>
        <translation>器官轴型 180 度</translation>
    </message>
    <message>
        <source>Partial, antrum only, 90 degrees</source>
        <translation>部分扭转，仅胃窦，90 度</translation>
    </message>
    <message>
        <source>Pronation, 60 degrees</source>
        <translation>旋前 60 度</translation>
    </message>
    <message>
        <source>Supination, 60 degrees</source>
        <translation>旋后 60 度</translation>
    </message>
    <message>
        <source>The whole pack of small bowel turns on the stalk of its vessels, as in a patient. The stalk is solid, of radius 8 mm and 60 mm long with an assumed shear modulus of 10 kPa (1.1 N mm a radian): patency stays 1, the shut duodenum is not modelled, and the coils are relief on one body that turns as a whole. Stalk, friction and vessels are assumed; limits of the jaw and the time to loss are sourced (pig jejunum). Blood flow against the angle was measured on testes only and is carried over. Colour is no proof of life. For training the hand and the order of steps; it says nothing about one patient.</source>
        <translation>整团小肠在其血管蒂上转动，与患者体内一样。血管蒂为实心，半径 8 mm，长 60 mm，剪切模量假设为 10 kPa（每弧度 1.1 N mm）：通畅度始终为 1，未模拟闭塞的十二指肠；肠袢只是一个整体表面上的起伏，整体转动。血管蒂、摩擦和血管为假设值；钳口的限值和坏死时间有文献来源（猪空肠）。血流与扭转角的关系只在睾丸上测量过，此处借用。颜色不能证明组织存活。仅用于训练手法和步骤顺序，不能用于判断具体患者。</translation>
    </message>
    <message>
        <source>Undo a midgut volvulus</source>
        <translation>复位中肠扭转</translation>
    </message>
    <message>
        <source>Undo a sigmoid volvulus</source>
        <translation>复位乙状结肠扭转</translation>
    </message>
    <message>
        <source>Undo a small-bowel loop</source>
        <translation>复位扭转的小肠袢</translation>
    </message>
    <message>
        <source>Undo mesentero-axial</source>
        <translation>复位胃系膜轴型扭转</translation>
    </message>
    <message>
        <source>Undo organo-axial</source>
        <translation>复位胃器官轴型扭转</translation>
    </message>
    <message>
        <source>Undo testicular torsion</source>
        <translation>复位睾丸扭转</translation>
    </message>
    <message>
        <source>dorsal forearm, 60 mm from the wrist crease</source>
        <translation>前臂背侧，距腕横纹 60 mm</translation>
    </message>
    <message>
        <source>dorsal wrist centre</source>
        <translation>腕背中点</translation>
    </message>
    <message>
        <source>fifth knuckle (ulnar border)</source>
        <translation>第五掌指关节（尺侧缘）</translation>
    </message>
    <message>
        <source>palmar forearm, 60 mm from the wrist crease</source>
        <translation>前臂掌侧，距腕横纹 60 mm</translation>
    </message>
    <message>
        <source>palmar wrist crease centre</source>
        <translation>掌侧腕横纹中点</translation>
    </message>
    <message>
        <source>radial styloid</source>
        <translation>桡骨茎突</translation>
    </message>
    <message>
        <source>second knuckle (index metacarpal head)</source>
        <translation>第二掌指关节（示指掌骨头）</translation>
    </message>
    <message>
        <source>thumb base (first carpometacarpal joint)</source>
        <translation>拇指根部（第一腕掌关节）</translation>
    </message>
    <message>
        <source>tip of the middle finger</source>
        <translation>中指尖</translation>
    </message>
    <message>
        <source>ulnar head</source>
        <translation>尺骨头</translation>
    </message>
    <message>
        <source>Four trainees also undo organs that come twisted, as a cohort of their own that follows the curriculum &quot;Volvulus and torsion: undo it&quot;. Two of these hands stop a turn too early and one closes the jaw too tightly, by design.</source>
        <translation>四名学员还练习复位扭转的器官，单独成为一个队列，按照课程《肠胃扭转与睾丸扭转：复位》进行。其中有意让两次操作省去最后一转，让一次操作钳夹过紧。</translation>
    </message>
    <message>
        <source>Tissue hurt</source>
        <translation>组织损伤</translation>
    </message>
    <message>
        <source>An organ that came twisted is undone; there are no targets and no angle errors. Time is that of the hand; where blood did not come back, it is censored and not in the median. From an ischaemic dose of 1 on the organ is lost.</source>
        <translation>将起初扭转的器官复位；没有目标角，也没有角度误差。时间为手的时间；血流未恢复者为删失，不计入中位数。缺血剂量达到 1 时器官即丧失。</translation>
    </message>
    <message>
        <source>Tissue was hurt where jaw or pull went beyond what it then bore.</source>
        <translation>钳夹或牵拉超过组织当时的承受力时即为组织损伤。</translation>
    </message>
    <message>
        <source>Simulated trainees who undo organs that come twisted</source>
        <translation>复位扭转器官的模拟学员</translation>
    </message>
    <message>
        <source>untwisting</source>
        <translation>扭转复位</translation>
    </message>
    <message>
        <source>found: %1; this kind of device was not confirmed on hardware yet</source>
        <translation>已找到：%1；此类设备尚未在真实硬件上确认</translation>
    </message>
    <message>
        <source>this device is not supported on this system yet</source>
        <translation>此系统尚不支持该设备</translation>
    </message>
    <message>
        <source>the values lie too close together to be squared</source>
        <translation>数值过于接近，无法求平方</translation>
    </message>
    <message>
        <source>the same as line %1: taken once</source>
        <translation>与第 %1 行相同：只导入一次</translation>
    </message>
    <message>
        <source>the text begins as UTF-16 and is broken</source>
        <translation>文本以 UTF-16 开头，但内容已损坏</translation>
    </message>
    <message>
        <source>the text is in no encoding that a spreadsheet saves</source>
        <translation>文本的编码不是电子表格软件会保存的任何一种</translation>
    </message>
    <message>
        <source>this case has not been called to the real arm yet</source>
        <translation>该案例尚未被呼叫到实物手臂</translation>
    </message>
    <message>
        <source>Its sheet opens by itself when the office calls it</source>
        <translation>管理员呼叫后，其评分表会自动打开</translation>
    </message>
    <message>
        <source>%1 has trained %2 of %3 min</source>
        <translation>%1 已训练 %2 分钟，应为 %3 分钟</translation>
    </message>
    <message>
        <source>%1 has trained %2 min already</source>
        <translation>%1 已训练 %2 分钟</translation>
    </message>
    <message>
        <source>Call somebody else</source>
        <translation>请呼叫其他人</translation>
    </message>
    <message>
        <source>this call has ended already</source>
        <translation>该呼叫已经结束</translation>
    </message>
    <message>
        <source>Read the board again</source>
        <translation>请刷新看板</translation>
    </message>
    <message>
        <source>this trainee is called in %1 already</source>
        <translation>该学员已在 %1 被呼叫</translation>
    </message>
    <message>
        <source>End that call first</source>
        <translation>请先结束那次呼叫</translation>
    </message>
    <message>
        <source>another trainee is called in this room</source>
        <translation>该房间已呼叫了另一名学员</translation>
    </message>
    <message>
        <source>no occasion is due</source>
        <translation>当前没有到期的评分时点</translation>
    </message>
    <message>
        <source>Choose the occasion</source>
        <translation>请选择评分时点</translation>
    </message>
    <message>
        <source>this cohort has no such occasion</source>
        <translation>该批次没有这个评分时点</translation>
    </message>
    <message>
        <source>no rater is asked to score %1 on the real arm at the occasion &quot;%2&quot;</source>
        <translation>未邀请任何评分者在评分时点“%2”于实物手臂上为 %1 评分</translation>
    </message>
    <message>
        <source>the scoring plan</source>
        <translation>评分计划</translation>
    </message>
    <message>
        <source>all sheets of the occasion &quot;%1&quot; are in</source>
        <translation>评分时点“%1”的评分表已全部提交</translation>
    </message>
    <message>
        <source>a call needs a room</source>
        <translation>呼叫必须指明房间</translation>
    </message>
    <message>
        <source>Say where the real arm stands</source>
        <translation>请填写实物手臂所在的房间</translation>
    </message>
    <message>
        <source>Say why the trainee is called nevertheless</source>
        <translation>请说明为何仍要呼叫该学员</translation>
    </message>
    <message>
        <source>a call is taken back with a reason only</source>
        <translation>撤回呼叫必须说明原因</translation>
    </message>
    <message>
        <source>a sheet of this call is submitted already</source>
        <translation>本次呼叫已有评分表提交</translation>
    </message>
    <message>
        <source>End the call and report a deviation</source>
        <translation>请结束呼叫并登记方案偏离</translation>
    </message>
    <message>
        <source>nobody in this cohort has this code</source>
        <translation>该批次中没有这个编号</translation>
    </message>
    <message>
        <source>Scan the card again, or type the code</source>
        <translation>请重新扫描卡片，或手动输入编号</translation>
    </message>
    <message>
        <source>Trainee called to the real arm</source>
        <translation>学员被呼叫到实物手臂</translation>
    </message>
    <message>
        <source>Call to the real arm ended</source>
        <translation>实物手臂呼叫结束</translation>
    </message>
    <message>
        <source>Call to the real arm taken back</source>
        <translation>实物手臂呼叫已撤回</translation>
    </message>
    <message>
        <source>Audit trail exported</source>
        <translation>审计记录已导出</translation>
    </message>
    <message>
        <source>call to the real arm</source>
        <translation>实物手臂呼叫</translation>
    </message>
    <message>
        <source>the marks of the panel are open now</source>
        <translation>评分组的评分已公开</translation>
    </message>
    <message>
        <source>Move your mark with a reason; it is flagged as moved after the panel&apos;s marks</source>
        <translation>请说明理由后调整评分；该调整将标记为在评分组评分公开之后作出</translation>
    </message>
    <message>
        <source>the answer of the tissue is not known throughout</source>
        <translation>组织的反应并非全程已知</translation>
    </message>
    <message>
        <source>How well practising with this model prepares for twisting a real organ.</source>
        <translation>用该模型练习对扭转真实器官的准备作用有多大。</translation>
    </message>
    <message>
        <source>teaches nothing or wrong habits</source>
        <translation>学不到东西，或养成错误习惯</translation>
    </message>
    <message>
        <source>useful beside other training</source>
        <translation>作为其他训练的补充有用</translation>
    </message>
    <message>
        <source>prepares as well as the real thing</source>
        <translation>准备效果与真实操作相当</translation>
    </message>
    <message>
        <source>How far the force in the hand is what tissue would answer, in size and course.</source>
        <translation>手上的力在大小和变化上与组织的真实反应有多接近。</translation>
    </message>
    <message>
        <source>no force, or one that misleads</source>
        <translation>没有力，或力会误导人</translation>
    </message>
    <message>
        <source>right in direction, not in size</source>
        <translation>方向正确，大小不对</translation>
    </message>
    <message>
        <source>feels like tissue</source>
        <translation>手感如同组织</translation>
    </message>
    <message>
        <source>How promptly picture and force follow the hand.</source>
        <translation>画面和力跟随手部动作的及时程度。</translation>
    </message>
    <message>
        <source>clearly behind the hand</source>
        <translation>明显滞后于手</translation>
    </message>
    <message>
        <source>a delay that can be noticed</source>
        <translation>可察觉到延迟</translation>
    </message>
    <message>
        <source>no delay to be noticed</source>
        <translation>察觉不到延迟</translation>
    </message>
    <message>
        <source>Whether organ and force stay calm through grip, twist, hold and release.</source>
        <translation>在夹持、扭转、保持和松开过程中，器官和力是否平稳。</translation>
    </message>
    <message>
        <source>shakes, jumps or breaks off</source>
        <translation>抖动、跳变或中断</translation>
    </message>
    <message>
        <source>calm but for single moments</source>
        <translation>除个别瞬间外平稳</translation>
    </message>
    <message>
        <source>calm throughout</source>
        <translation>全程平稳</translation>
    </message>
    <message>
        <source>How quickly the shape of the organ follows a large or fast twist.</source>
        <translation>大幅或快速扭转时，器官形状跟随的速度。</translation>
    </message>
    <message>
        <source>the shape lags or stands still</source>
        <translation>形状滞后或不动</translation>
    </message>
    <message>
        <source>keeps up with slow twists</source>
        <translation>跟得上缓慢的扭转</translation>
    </message>
    <message>
        <source>keeps up with every twist</source>
        <translation>跟得上任何扭转</translation>
    </message>
    <message>
        <source>How true the twisted shape is: where it turns, folds and gives way.</source>
        <translation>扭转后的形状有多真实：何处转动、起皱和变形。</translation>
    </message>
    <message>
        <source>no organ twists like that</source>
        <translation>没有器官会这样扭转</translation>
    </message>
    <message>
        <source>right as a whole, wrong in places</source>
        <translation>整体正确，局部有误</translation>
    </message>
    <message>
        <source>like the organ itself</source>
        <translation>与器官本身一样</translation>
    </message>
    <message>
        <source>How evenly the picture moves.</source>
        <translation>画面运动的流畅程度。</translation>
    </message>
    <message>
        <source>stops and jumps</source>
        <translation>停顿、跳动</translation>
    </message>
    <message>
        <source>stutters now and then</source>
        <translation>偶有卡顿</translation>
    </message>
    <message>
        <source>even throughout</source>
        <translation>全程流畅</translation>
    </message>
    <message>
        <source>How far one forgets the device and works on the organ itself.</source>
        <translation>在多大程度上忘记设备，仿佛直接操作器官。</translation>
    </message>
    <message>
        <source>one steers a device</source>
        <translation>感觉在操纵设备</translation>
    </message>
    <message>
        <source>at times one works on the organ</source>
        <translation>有时感觉在操作器官</translation>
    </message>
    <message>
        <source>one works on the organ</source>
        <translation>感觉就在操作器官</translation>
    </message>
    <message>
        <source>How much the surface looks like living tissue: colour, gloss, grain, vessels.</source>
        <translation>表面与活体组织的相似程度：颜色、光泽、纹理、血管。</translation>
    </message>
    <message>
        <source>like plastic</source>
        <translation>像塑料</translation>
    </message>
    <message>
        <source>tissue at a glance</source>
        <translation>乍看像组织</translation>
    </message>
    <message>
        <source>like living tissue</source>
        <translation>如同活体组织</translation>
    </message>
    <message>
        <source>there is no such exercise in a published curriculum</source>
        <translation>已发布的课程中没有这个练习</translation>
    </message>
    <message>
        <source>a tolerance chosen by hand needs a reason</source>
        <translation>自行选定的容差需要说明理由</translation>
    </message>
    <message>
        <source>competence design</source>
        <translation>胜任标准</translation>
    </message>
    <message>
        <source>Write why, in a few words</source>
        <translation>请简短写明原因</translation>
    </message>
    <message>
        <source>Let more experts make a run, or keep the tolerance of the exercise</source>
        <translation>请让更多专家完成一次操作，或保留练习的容差</translation>
    </message>
    <message>
        <source>Keep the tolerance of the exercise</source>
        <translation>请保留练习的容差</translation>
    </message>
    <message>
        <source>an untwisting that passes</source>
        <translation>一次通过的复位</translation>
    </message>
    <message>
        <source>Competence design, version %1</source>
        <translation>胜任标准第 %1 版</translation>
    </message>
    <message>
        <source>Competence design shipped with the exercise (none was registered before the first attempt)</source>
        <translation>随练习提供的胜任标准（首次尝试前没有登记标准）</translation>
    </message>
    <message>
        <source>learning</source>
        <translation>学习中</translation>
    </message>
    <message>
        <source>able, since attempt %1</source>
        <translation>自第 %1 次尝试起胜任</translation>
    </message>
    <message>
        <source>able since attempt %1; the last attempts raise a doubt</source>
        <translation>自第 %1 次尝试起胜任；最近几次尝试令人存疑</translation>
    </message>
    <message>
        <source>able at attempt %1, not any more</source>
        <translation>在第 %1 次尝试时胜任，现在不再是</translation>
    </message>
    <message>
        <source>must lie above 0 and below 1</source>
        <translation>必须大于 0 且小于 1</translation>
    </message>
    <message>
        <source>Give a share such as 0.05</source>
        <translation>请给出比例，例如 0.05</translation>
    </message>
    <message>
        <source>adequate failure rate</source>
        <translation>胜任者的失败率</translation>
    </message>
    <message>
        <source>inadequate failure rate</source>
        <translation>未胜任者的失败率</translation>
    </message>
    <message>
        <source>largest false pass</source>
        <translation>最大误通过率</translation>
    </message>
    <message>
        <source>largest false fail</source>
        <translation>最大误不通过率</translation>
    </message>
    <message>
        <source>must be greater than the adequate one</source>
        <translation>必须大于胜任者的失败率</translation>
    </message>
    <message>
        <source>Give two rates that differ, such as 0.1 and 0.3</source>
        <translation>请给出两个不同的失败率，例如 0.1 和 0.3</translation>
    </message>
    <message>
        <source>must lie between 1 and %1</source>
        <translation>必须在 1 到 %1 之间</translation>
    </message>
    <message>
        <source>number of attempts</source>
        <translation>尝试次数</translation>
    </message>
    <message>
        <source>Give as many as a trainee makes, such as 50</source>
        <translation>请给出学员会做的次数，例如 50</translation>
    </message>
    <message>
        <source>must lie above 0 and at most at 180 degrees</source>
        <translation>必须大于 0 且不超过 180 度</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>容差</translation>
    </message>
    <message>
        <source>Give an angle in degrees</source>
        <translation>请以度给出角度</translation>
    </message>
    <message>
        <source>no limit keeps the largest false pass within these attempts</source>
        <translation>在这些尝试次数内，没有界限能保证最大误通过率</translation>
    </message>
    <message>
        <source>Plan more attempts, or rates that lie farther apart</source>
        <translation>请计划更多次尝试，或让两个失败率相差更大</translation>
    </message>
    <message>
        <source>Competence design registered</source>
        <translation>已登记胜任标准</translation>
    </message>
    <message>
        <source>The interaction is the question: whether the groups take different courses. Greenhouse-Geisser epsilon %1.</source>
        <translation>关键是交互作用：各组的进程是否不同。Greenhouse-Geisser ε 为 %1。</translation>
    </message>
    <message>
        <source>a competence verdict is in a group that does not exist, or has no limit</source>
        <translation>一项胜任判定属于不存在的组，或没有界限</translation>
    </message>
    <message>
        <source>How the groups were made is not in the record: they may differ from the start.</source>
        <translation>记录中没有说明如何分组：各组一开始就可能不同。</translation>
    </message>
    <message>
        <source>No test of baseline differences is shown: allocation was drawn, so any difference is due to chance.</source>
        <translation>不显示基线差异的检验：分组由抽取决定，任何差异都出于偶然。</translation>
    </message>
    <message>
        <source>The paper gives the scale of the model evaluation as 0 to 10 and that of the training study as 1 to 10; here they run from %1 to %2 and from %3 to %4.</source>
        <translation>论文中模型评价的量表为 0 到 10，训练研究的量表为 1 到 10；此处分别为 %1 到 %2 和 %3 到 %4。</translation>
    </message>
    <message>
        <source>Who is held to be able is judged by LC-CUSUM, by the designs and with the error rates of the section Competence.</source>
        <translation>谁被认为胜任由 LC-CUSUM 判定，所用标准和错误率见“胜任”一节。</translation>
    </message>
    <message>
        <source>%1. %2 %3</source>
        <translation>%1。%2%3</translation>
    </message>
    <message>
        <source>LC-CUSUM of every trainee and exercise</source>
        <translation>每名学员每个练习的 LC-CUSUM</translation>
    </message>
    <message>
        <source>number of the attempt</source>
        <translation>尝试序号</translation>
    </message>
    <message>
        <source>cumulative sum, share of the limit</source>
        <translation>累积和，占界限的比例</translation>
    </message>
    <message>
        <source>able</source>
        <translation>胜任</translation>
    </message>
    <message>
        <source>A success raises the sum, a failure lowers it, never below zero. A line ends where it reaches the limit: the trainee is held to be able from there on, with the error rates stated above.</source>
        <translation>成功使累积和上升，失败使其下降，但不低于零。线在达到界限处结束：从那时起学员被认为胜任，错误率如上所述。</translation>
    </message>
    <message>
        <source>Competence of every trainee</source>
        <translation>每名学员的胜任判定</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>练习</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>尝试次数</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>False pass</source>
        <translation>误通过</translation>
    </message>
    <message>
        <source>False fail</source>
        <translation>误不通过</translation>
    </message>
    <message>
        <source>Within attempts</source>
        <translation>在多少次尝试内</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>标准</translation>
    </message>
    <message>
        <source>registered, version %1</source>
        <translation>已登记，第 %1 版</translation>
    </message>
    <message>
        <source>shipped with the exercise</source>
        <translation>随练习提供</translation>
    </message>
    <message>
        <source>Competence by group</source>
        <translation>各组的胜任情况</translation>
    </message>
    <message>
        <source>Able now and not able, trainees</source>
        <translation>目前胜任与未胜任的学员数</translation>
    </message>
    <message>
        <source>not able</source>
        <translation>未胜任</translation>
    </message>
    <message>
        <source>Competence</source>
        <translation>胜任</translation>
    </message>
    <message>
        <source>Raters scored the models on %1 indices from %2 to %3 points; %4 marks are missing. Raters: %5.</source>
        <translation>评分者按 %1 项指标以 %2 到 %3 分评价模型；缺少 %4 个评分。评分者：%5。</translation>
    </message>
    <message>
        <source>Twists on the simulator only; a point needs at least two trainees.</source>
        <translation>仅含模拟器上的扭转；每个点至少需要两名学员。</translation>
    </message>
    <message>
        <source>exponential learning curve</source>
        <translation>指数学习曲线</translation>
    </message>
    <message>
        <source>plan of the arms; times noted; lengths of the recordings</source>
        <translation>各研究组的计划；登记的时间；录制的长度</translation>
    </message>
    <message>
        <source>Virtual, planned (min)</source>
        <translation>虚拟，计划（min）</translation>
    </message>
    <message>
        <source>Virtual, mean noted (min)</source>
        <translation>虚拟，平均登记（min）</translation>
    </message>
    <message>
        <source>Virtual, mean recorded (min)</source>
        <translation>虚拟，平均录制（min）</translation>
    </message>
    <message>
        <source>Real, planned (min)</source>
        <translation>真实，计划（min）</translation>
    </message>
    <message>
        <source>Real, mean noted (min)</source>
        <translation>真实，平均登记（min）</translation>
    </message>
    <message>
        <source>no plan</source>
        <translation>无计划</translation>
    </message>
    <message>
        <source>Recordings make up %1 % of the time noted on the simulator; the rest was spent between the runs, or is not recorded.</source>
        <translation>录制占模拟器登记时间的 %1 %；其余时间用在各次操作之间，或没有录制。</translation>
    </message>
    <message>
        <source>Strictest first. Scores are not corrected for severity, and not every trainee is scored by the same raters: a strict or lenient rater may change their order.</source>
        <translation>最严格者在前。得分未按严格程度校正，且并非每名学员都由相同的评分者评分：严格或宽松的评分者可能改变学员的次序。</translation>
    </message>
    <message>
        <source>The groups have %1 trainees. Two groups of %2 have a power of %3 in a two-sided t test at 5 % for a difference of 0.8 standard deviations, and detect one of %4 with a power of 0.80. A difference that is not significant is no evidence of equality.</source>
        <translation>各组人数为 %1。两个各 %2 人的组在 5 % 水平的双侧 t 检验中，对 0.8 个标准差的差异的检验效能为 %3；以 0.80 的效能可检出 %4 个标准差的差异。差异不显著并不证明相等。</translation>
    </message>
    <message>
        <source>No commitment to the seed is in the record.</source>
        <translation>记录中没有对种子的承诺。</translation>
    </message>
    <message>
        <source>Commitment to the seed: %1; when it was made is not in the record.</source>
        <translation>对种子的承诺：%1；记录中没有作出承诺的时间。</translation>
    </message>
    <message>
        <source>Commitment to the seed: %1, made %2, before the first enrolment.</source>
        <translation>对种子的承诺：%1，作出于 %2，在首次入组之前。</translation>
    </message>
    <message>
        <source>The sequence was repeated from the seed and was NOT found the same.</source>
        <translation>已由种子重复该序列，结果不一致。</translation>
    </message>
    <message>
        <source>How many raters are needed</source>
        <translation>需要多少名评分者</translation>
    </message>
    <message>
        <source>G-study of trainees x raters, last occasion; D-study</source>
        <translation>最后时点学员 × 评分者的概化研究；决策研究</translation>
    </message>
    <message>
        <source>Dependability (level)</source>
        <translation>可靠性（水平）</translation>
    </message>
    <message>
        <source>Generalizability (order)</source>
        <translation>概化系数（次序）</translation>
    </message>
    <message>
        <source>Standard error of the mean mark (points)</source>
        <translation>平均评分的标准误（分）</translation>
    </message>
    <message>
        <source>Components of variance: trainees %1, raters %2, rest %3.</source>
        <translation>方差分量：学员 %1，评分者 %2，其余 %3。</translation>
    </message>
    <message>
        <source>Raters on one scale, last occasion</source>
        <translation>同一量尺上的评分者，最后时点</translation>
    </message>
    <message>
        <source>many-facet Rasch model, joint maximum likelihood</source>
        <translation>多面 Rasch 模型，联合极大似然</translation>
    </message>
    <message>
        <source>Severity (logits)</source>
        <translation>严格程度（对数单位）</translation>
    </message>
    <message>
        <source>Standard error</source>
        <translation>标准误</translation>
    </message>
    <message>
        <source>Infit</source>
        <translation>加权拟合</translation>
    </message>
    <message>
        <source>Outfit</source>
        <translation>未加权拟合</translation>
    </message>
    <message>
        <source>only extreme marks</source>
        <translation>只有极端评分</translation>
    </message>
    <message>
        <source>Positive: stricter. Severities sum to zero. Infit and outfit are about 1 where a rater&apos;s marks follow the model; the marks that occur, in their order, are its categories. Joint estimates lie somewhat too far apart.</source>
        <translation>正值：更严格。严格程度之和为零。评分符合模型时，两种拟合值约为 1；出现过的评分按次序作为类别。联合估计值之间的距离略偏大。</translation>
    </message>
    <message>
        <source>What each group gained by itself</source>
        <translation>各组自身的进步</translation>
    </message>
    <message>
        <source>exact signed ranks; Friedman; bootstrap of the median, BCa</source>
        <translation>精确符号秩；Friedman；中位数的自助法，偏差校正加速区间</translation>
    </message>
    <message>
        <source>Median gain [95 %] (points)</source>
        <translation>进步的中位数 [95 %]（分）</translation>
    </message>
    <message>
        <source>Signed ranks V</source>
        <translation>符号秩 V</translation>
    </message>
    <message>
        <source>p (Friedman, all occasions)</source>
        <translation>p（Friedman，全部时点）</translation>
    </message>
    <message>
        <source>Scores of fewer than %1 marks, and means of fewer than %1 trainees or with such a score among them, are left out: a single mark could be read from them.</source>
        <translation>少于 %1 个评分的得分，以及少于 %1 名学员或含有这类得分的均值均不显示：否则可从中读出单个评分。</translation>
    </message>
    <message>
        <source>Corresponds to Fig. %1 of the paper. A score is the mean over the raters.</source>
        <translation>对应论文图 %1。得分为各评分者的平均。</translation>
    </message>
    <message>
        <source>Training was shortened for this demonstration.</source>
        <translation>本演示缩短了训练。</translation>
    </message>
    <message>
        <source>of the exercise</source>
        <translation>来自练习</translation>
    </message>
    <message>
        <source>from the centre&apos;s own experts</source>
        <translation>来自本中心的专家</translation>
    </message>
    <message>
        <source>chosen by the centre</source>
        <translation>由本中心选定</translation>
    </message>
    <message>
        <source>The times of training are those of the protocol, in full: one trainee an hour, six a day; every second trainee of a group takes the whole rest between the two halves.</source>
        <translation>训练时间完全按方案：每小时一名学员，每天六名；每组每两名学员中有一名在前后两半之间用满全部休息时间。</translation>
    </message>
    <message>
        <source>trained before scoring</source>
        <translation>评分前已训练</translation>
    </message>
    <message>
        <source>Program file (BLAKE2b)</source>
        <translation>程序文件（BLAKE2b）</translation>
    </message>
    <message>
        <source>there is no such sheet of the real arm</source>
        <translation>没有这样的实物手臂评分表</translation>
    </message>
    <message>
        <source>this sheet is in already, or was withdrawn</source>
        <translation>该评分表已提交或已撤回</translation>
    </message>
    <message>
        <source>overall mark</source>
        <translation>总分</translation>
    </message>
    <message>
        <source>no mark of the scale and no reason: %1</source>
        <translation>既无量表内的分数，也无理由：%1</translation>
    </message>
    <message>
        <source>Type what stands on the paper; where it says nothing, say that as the reason</source>
        <translation>请录入纸上的内容；若纸上空白，请将此作为理由</translation>
    </message>
    <message>
        <source>Be scored on the real arm first, or say why the training begins nevertheless</source>
        <translation>请先在实物手臂上接受评分，或说明为何仍要开始训练</translation>
    </message>
    <message>
        <source>%1 points [%2; %3]</source>
        <translation>%1 分 [%2; %3]</translation>
    </message>
    <message>
        <source>Question: do trainees score differently at the end (%1) who trained in different ways: %2?</source>
        <translation>问题：训练方式不同的学员在结束时（%1）得分是否不同：%2？</translation>
    </message>
    <message>
        <source>Answer: none. The groups are not compared: %1.</source>
        <translation>答案：无。各组未作比较：%1。</translation>
    </message>
    <message>
        <source>%1: %2, %3 after Holm</source>
        <translation>%1：%2，Holm 校正后 %3</translation>
    </message>
    <message>
        <source>Answer: none. There is only one group.</source>
        <translation>答案：无。只有一个组。</translation>
    </message>
    <message>
        <source>Every interval holds zero.</source>
        <translation>所有区间都包含零。</translation>
    </message>
    <message>
        <source>No p value stays below %1 after Holm.</source>
        <translation>Holm 校正后没有 p 值低于 %1。</translation>
    </message>
    <message>
        <source>The answer: differences between the groups with 95 % intervals</source>
        <translation>答案：各组之间的差异及 95 % 区间</translation>
    </message>
    <message>
        <source>Scores at the end, and who reached the standard</source>
        <translation>结束时的得分，以及谁达到了标准</translation>
    </message>
    <message>
        <source>mean of the trainee scores; LC-CUSUM</source>
        <translation>学员得分的均值；LC-CUSUM</translation>
    </message>
    <message>
        <source>Mean score [lowest; highest]</source>
        <translation>平均得分 [最低; 最高]</translation>
    </message>
    <message>
        <source>did not train there</source>
        <translation>未在模拟器上训练</translation>
    </message>
    <message>
        <source>Signatures</source>
        <translation>签名</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>姓名</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>角色</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Signature</source>
        <translation>签名</translation>
    </message>
    <message>
        <source>At a glance</source>
        <translation>概览</translation>
    </message>
    <message>
        <source>SEM of one rater (points)</source>
        <translation>单个评分者的测量标准误（分）</translation>
    </message>
    <message>
        <source>SEM of the mean (points)</source>
        <translation>均值的测量标准误（分）</translation>
    </message>
    <message>
        <source>%1, every mark</source>
        <translation>%1，全部评分</translation>
    </message>
    <message>
        <source>Marks are missing: the first line of an occasion is made from the trainees whom every rater scored, the second from every mark, with variances by restricted maximum likelihood.</source>
        <translation>有评分缺失：每个评分时点的第一行仅含所有评分者都评过的学员，第二行使用全部评分，方差由限制性极大似然估计。</translation>
    </message>
    <message>
        <source>Agreement of the raters within each group</source>
        <translation>各组内的评分者一致性</translation>
    </message>
    <message>
        <source>Shrout and Fleiss ICC(2,1), ICC(2,k), each group alone</source>
        <translation>Shrout-Fleiss 组内相关系数 ICC(2,1)、ICC(2,k)，逐组计算</translation>
    </message>
    <message>
        <source>Differences between the groups make raters agree in the table above. What counts for comparing trainees of one group stands here.</source>
        <translation>上表的一致性部分来自组间差异。比较同组学员时应看本表。</translation>
    </message>
    <message>
        <source>Left out, without a score at every occasion: %1.</source>
        <translation>未纳入（并非每个评分时点都有得分）：%1。</translation>
    </message>
    <message>
        <source>%1 trainees</source>
        <translation>%1 名学员</translation>
    </message>
    <message>
        <source>The trainee is the unit of analysis. p values are adjusted by Holm&apos;s method where it is said.</source>
        <translation>以学员为分析单位。注明之处，p 值按 Holm 法校正。</translation>
    </message>
    <message>
        <source>Groups are not compared: there are fewer than two occasions.</source>
        <translation>未作组间比较：评分时点少于两个。</translation>
    </message>
    <message>
        <source>for a score before between %1 and %2</source>
        <translation>训练前得分在 %1 与 %2 之间时</translation>
    </message>
    <message>
        <source>for a score before below %1 or above %2</source>
        <translation>训练前得分低于 %1 或高于 %2 时</translation>
    </message>
    <message>
        <source>for every score before</source>
        <translation>任何训练前得分</translation>
    </message>
    <message>
        <source>for no score before</source>
        <translation>没有任何训练前得分</translation>
    </message>
    <message>
        <source>Test of equal slopes: %1; one slope for all groups is kept.</source>
        <translation>斜率相等检验：%1；各组沿用同一斜率。</translation>
    </message>
    <message>
        <source>Test of equal slopes: %1. The slopes differ, so that a difference depends on the score before: read the table with a slope for each group in place of this one.</source>
        <translation>斜率相等检验：%1。各组斜率不同，差异随训练前得分而变：请改看各组斜率分开的表。</translation>
    </message>
    <message>
        <source>Mean scores of the groups</source>
        <translation>各组平均得分</translation>
    </message>
    <message>
        <source>mean over trainees, Student&apos;s t</source>
        <translation>学员均值，Student t 区间</translation>
    </message>
    <message>
        <source>Mean [95 %, not adjusted]</source>
        <translation>均值 [95 %，未校正]</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>标准差</translation>
    </message>
    <message>
        <source>Every trainee with a score at the occasion. Intervals of single means that overlap do not say that the means agree: look at the differences.</source>
        <translation>包括该评分时点有得分的全部学员。单个均值的区间重叠并不说明均值相同，请看差异。</translation>
    </message>
    <message>
        <source>Difference [95 %, not adjusted]</source>
        <translation>差异 [95 %，未校正]</translation>
    </message>
    <message>
        <source>[95 %, all pairs together]</source>
        <translation>[95 %，所有配对同时成立]</translation>
    </message>
    <message>
        <source>Hedges g of the end scores [95 %, not adjusted]</source>
        <translation>结束得分的 Hedges g [95 %，未校正]</translation>
    </message>
    <message>
        <source>Intervals of all pairs together are widened after Bonferroni: all of them hold at once with 95 % or more. They are wider than Holm&apos;s p values ask for.</source>
        <translation>“所有配对同时成立”的区间按 Bonferroni 法加宽：全部同时成立的概率不低于 95 %，比 Holm 法 p 值所要求的更宽。</translation>
    </message>
    <message>
        <source>Scores at the end where each group has a slope of its own</source>
        <translation>各组斜率分开时的结束得分</translation>
    </message>
    <message>
        <source>analysis of covariance, separate slopes; Johnson and Neyman</source>
        <translation>协方差分析，斜率分开；Johnson-Neyman 法</translation>
    </message>
    <message>
        <source>Score before</source>
        <translation>训练前得分</translation>
    </message>
    <message>
        <source>Differ (5 %)</source>
        <translation>有差异（5 %）</translation>
    </message>
    <message>
        <source>Slopes: %1. Stated scores before: the mean of all and one standard deviation to either side. p (Holm) over all rows. This analysis was not planned: the test of equal slopes asked for it.</source>
        <translation>斜率：%1。所取训练前得分为全体均值及其上下各一个标准差。p（Holm）对所有行校正。本分析不在计划之内，由斜率相等检验引出。</translation>
    </message>
    <message>
        <source>linear mixed model; analysis of covariance, one pooled slope</source>
        <translation>线性混合模型；协方差分析，共用一个斜率</translation>
    </message>
    <message>
        <source>complete cases [95 %]</source>
        <translation>完整案例 [95 %]</translation>
    </message>
    <message>
        <source>mixed model, primary [95 %]</source>
        <translation>混合模型，主要分析 [95 %]</translation>
    </message>
    <message>
        <source>First group minus second group. An interval that crosses zero leaves the direction open. Intervals are not adjusted for the number of pairs.</source>
        <translation>第一组减第二组。跨过零的区间不能确定方向。区间未按配对数校正。</translation>
    </message>
    <message>
        <source>Residuals of the analysis of covariance</source>
        <translation>协方差分析的残差</translation>
    </message>
    <message>
        <source>score at the end minus what the model says</source>
        <translation>结束得分减模型预测值</translation>
    </message>
    <message>
        <source>Residuals beside those of a normal distribution</source>
        <translation>残差与正态分布的对照</translation>
    </message>
    <message>
        <source>residuals in order against normal quantiles at (i - 0.5) / n</source>
        <translation>按大小排列的残差与 (i - 0.5) / n 处的正态分位数</translation>
    </message>
    <message>
        <source>what the model says (points)</source>
        <translation>模型预测值（分）</translation>
    </message>
    <message>
        <source>residual (points)</source>
        <translation>残差（分）</translation>
    </message>
    <message>
        <source>as the model says</source>
        <translation>与模型一致</translation>
    </message>
    <message>
        <source>normal quantile times standard deviation (points)</source>
        <translation>正态分位数乘标准差（分）</translation>
    </message>
    <message>
        <source>A fan or a bow says that spread or slope are not as the model takes them.</source>
        <translation>若呈扇形或弓形，说明离散度或斜率与模型假设不符。</translation>
    </message>
    <message>
        <source>Planned and used: the analysis of covariance of the score at the end on the score before. No mark of the first and the last occasion is missing.</source>
        <translation>计划与实际采用的分析：以训练前得分为协变量的结束得分协方差分析。首末两个评分时点没有评分缺失。</translation>
    </message>
    <message>
        <source>Planned: the analysis of covariance of the score at the end on the score before. %1, so the linear mixed model is the primary comparison here: it takes every mark at the end that was given. The planned analysis stands beside it, of the %2 trainees with a score at both occasions.</source>
        <translation>计划的分析：以训练前得分为协变量的结束得分协方差分析。%1，因此此处以线性混合模型为主要比较，它使用结束时给出的每一个评分。计划的分析并列给出，含两个评分时点都有得分的 %2 名学员。</translation>
    </message>
    <message>
        <source>Planned: the analysis of covariance of the score at the end on the score before. %1. The linear mixed model that would take every mark is not defined (%2), so the planned analysis is used, of the %3 trainees with a score at both occasions.</source>
        <translation>计划的分析：以训练前得分为协变量的结束得分协方差分析。%1。可使用每个评分的线性混合模型无法定义（%2），因此采用计划的分析，含两个评分时点都有得分的 %3 名学员。</translation>
    </message>
    <message>
        <source>Left out of both, without any mark at one of the two: %1.</source>
        <translation>两种分析均未纳入（其中一个评分时点没有任何评分）：%1。</translation>
    </message>
    <message>
        <source>Both take it that whether a mark is missing does not depend on what it would have been, once group and score before are known. The table of bounds says what the missing marks could do at worst.</source>
        <translation>两种分析都假定：在已知组别和训练前得分时，评分是否缺失与其本来的数值无关。界限表说明缺失评分在最坏情况下的影响。</translation>
    </message>
    <message>
        <source>Trainees of whom marks are missing</source>
        <translation>有评分缺失的学员</translation>
    </message>
    <message>
        <source>Marks missing before</source>
        <translation>训练前缺失评分数</translation>
    </message>
    <message>
        <source>Marks missing at the end</source>
        <translation>结束时缺失评分数</translation>
    </message>
    <message>
        <source>Compared</source>
        <translation>参与比较</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>Missing: short of the number of marks that most trainees have at that occasion.</source>
        <translation>缺失：少于该评分时点多数学员的评分数。</translation>
    </message>
    <message>
        <source>Marks at the end, adjusted for the score before: every mark given</source>
        <translation>结束时评分，以训练前得分校正：使用给出的每个评分</translation>
    </message>
    <message>
        <source>linear mixed model, restricted maximum likelihood</source>
        <translation>线性混合模型，限制性极大似然</translation>
    </message>
    <message>
        <source>Effect of the group: F(%1, %2) = %3, %4.</source>
        <translation>组别效应：F(%1, %2) = %3，%4。</translation>
    </message>
    <message>
        <source>What the missing marks could do at worst</source>
        <translation>缺失评分在最坏情况下的影响</translation>
    </message>
    <message>
        <source>analysis of covariance, missing marks at the ends of the scale</source>
        <translation>协方差分析，缺失评分取量表两端</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>first is better whatever is missing</source>
        <translation>无论缺失为何，第一组更好</translation>
    </message>
    <message>
        <source>second is better whatever is missing</source>
        <translation>无论缺失为何，第二组更好</translation>
    </message>
    <message>
        <source>not decided</source>
        <translation>未定</translation>
    </message>
    <message>
        <source>Every missing mark at the end is taken as the lowest of the scale in one group and as the highest in the other. Who has no score before is given the mean of the others.</source>
        <translation>结束时的每个缺失评分在一组取量表最低分、在另一组取最高分。没有训练前得分者取其他人的均值。</translation>
    </message>
    <message>
        <source>each mark against the mean of the others, limits for repeated measures</source>
        <translation>每个评分与其余评分者均值的比较，重复测量的界限</translation>
    </message>
    <message>
        <source>Limits for repeated measures: plus and minus 1.96 standard deviations of one rater&apos;s mark about the mean of %1 others, %2 points, from the variances of raters and rest over all trainees.</source>
        <translation>重复测量的界限：单个评分者的评分相对于另外 %1 名评分者均值的正负 1.96 个标准差，即 %2 分，由全体学员的评分者方差和残差方差得出。</translation>
    </message>
    <message>
        <source>too few trainees with every mark</source>
        <translation>评分齐全的学员太少</translation>
    </message>
    <message>
        <source>the slopes do not differ</source>
        <translation>斜率没有差异</translation>
    </message>
    <message>
        <source>no mark is missing</source>
        <translation>没有评分缺失</translation>
    </message>
    <message>
        <source>there are too few marks to tell trainees, raters and error apart</source>
        <translation>评分太少，无法区分学员、评分者与误差</translation>
    </message>
    <message>
        <source>the marks leave no residual</source>
        <translation>评分没有残差</translation>
    </message>
    <message>
        <source>the marks leave no residual, or the fit does not settle</source>
        <translation>评分没有残差，或拟合不收敛</translation>
    </message>
    <message>
        <source>the marks do not tell the variances apart</source>
        <translation>评分无法区分各方差</translation>
    </message>
    <message>
        <source>there are too few degrees of freedom</source>
        <translation>自由度太少</translation>
    </message>
    <message>
        <source>the numbers are too large to add up exactly</source>
        <translation>数值太大，无法精确相加</translation>
    </message>
    <message>
        <source>this organ is not to be undone in stages</source>
        <translation>该器官不要求分阶段复位</translation>
    </message>
    <message>
        <source>A left testis is twisted by one to two turns, mostly inwards; one in five turned outwards. Open it like a book: turn the left one clockwise as seen from below, and back at once if the torque rises. Pain goes before the twist has gone: turn until nothing is left and check the flow. After a whole turn let it rest for five minutes before you turn on. Eight hours cost the testis.</source>
        <translation>左侧睾丸扭转一到两圈，多向内侧，五分之一向外侧。像翻书一样打开：从下方看，左侧顺时针转；力矩增大就立即反向。疼痛会先于扭转消失：要转到完全复位，并检查血流。每转一整圈后，先停歇五分钟再继续。八小时可失去睾丸。</translation>
    </message>
    <message>
        <source>A loop of small bowel of 27 mm width, wrung between its two feet and the part in the hand. The mobile part turns as a whole about the straight line between its ends and the limbs are wrung; they do not wind round each other, the mesentery is not drawn. The law of the wall was checked for length over radius 3 to 12 and wall over radius 0.03 to 0.1. The limbs are 82 mm long on a mean radius of 12 mm (6.8) with a wall over radius of 0.085 to 0.105: inside, the narrowest places 5 % beyond. Pressure times radius over stiffness times wall is 0.9, held against a second computation up to 0.5 only. The lumen shuts near 200 degrees. Wall, pressure, stiffness of the wall, friction and the length of the vessels are assumed; the limits of the jaw and the time to loss are sourced (pig jejunum). Blood flow against the angle was measured on testes only and is carried over. Colour is no proof of life. For training the hand and the order of steps; it says nothing about one patient.</source>
        <translation>一段宽 27 mm 的小肠袢，在两个肠脚与手中部分之间被拧转。活动部分作为整体绕其两端之间的直线转动，两肢被拧转；两肢不会相互缠绕，系膜未画出。管壁定律在长度与半径之比 3 至 12、壁厚与半径之比 0.03 至 0.1 的范围内验证过。两肢长 82 mm，平均半径 12 mm（比值 6.8），壁厚与半径之比为 0.085 至 0.105：在范围之内，最窄处超出 5%。压力乘半径除以刚度与壁厚之积为 0.9，而与另一种计算的对照只做到 0.5。肠腔在约 200 度时闭合。壁厚、压力、管壁刚度、摩擦和血管长度为假设值；器械钳口的限值和坏死时间有文献来源（猪空肠）。血流与扭转角的关系只在睾丸上测量过，此处借用。颜色不能证明组织存活。仅用于训练手法和步骤顺序，不能用于判断具体患者。</translation>
    </message>
    <message>
        <source>A stomach that is held at pylorus and cardia; the body between is in the hand. The mobile part turns as a whole about the straight line between its ends, antrum and upper body are wrung about their own curved axis; the mesentery is not drawn. In a patient the greater curvature swings about the straight line between cardia and pylorus. The law of the wall was checked for length over radius 3 to 12 and wall over radius 0.03 to 0.1. The antrum is 92 mm long on a mean radius of 24 mm (3.9) with a wall over radius of 0.06 to 0.35, the upper body 92 mm on 35 mm (2.6) with 0.05 to 0.07: the thick antrum and the short body lie outside. Pressure times radius over stiffness times wall is 2.5 and 3.8 at 8 mmHg, held against a second computation up to 0.5 only. The lumen shuts between 85 and 110 degrees, earlier than the 180 of surgeons, because two short stretches take the whole turn. Thickness and the pressure of a fasted stomach are sourced; the pressure of the volvulus, the stiffness of the wall, friction and vessels are assumed. Blood flow against the angle was measured on testes only and is carried over. Colour is no proof of life. For training the hand and the order of steps; it says nothing about one patient.</source>
        <translation>胃固定在幽门和贲门，中间的胃体握在手中。活动部分作为整体绕其两端之间的直线转动，胃窦和胃体上部绕各自弯曲的轴线被拧转；系膜未画出。在患者体内，胃大弯绕贲门与幽门之间的直线翻转。管壁定律在长度与半径之比 3 至 12、壁厚与半径之比 0.03 至 0.1 的范围内验证过。胃窦长 92 mm，平均半径 24 mm（比值 3.9），壁厚与半径之比为 0.06 至 0.35；胃体上部长 92 mm，半径 35 mm（比值 2.6），壁厚与半径之比为 0.05 至 0.07：较厚的胃窦和较短的胃体在范围之外。8 mmHg 时压力乘半径除以刚度与壁厚之积为 2.5 和 3.8，而与另一种计算的对照只做到 0.5。胃腔在 85 至 110 度之间闭合，早于外科医生所说的 180 度，因为全部转角由两段较短的胃承担。壁厚和空腹时的胃内压有文献来源；扭转时的压力、管壁刚度、摩擦和血管为假设值。血流与扭转角的关系只在睾丸上测量过，此处借用。颜色不能证明组织存活。仅用于训练手法和步骤顺序，不能用于判断具体患者。</translation>
    </message>
    <message>
        <source>A testis turns on its cord as it does in a patient. The cord is solid, of radius 6 mm and 60 mm long with an assumed shear modulus of 10 kPa (0.34 N mm a radian), without wall, lumen or folds: patency stays 1. Vessels: the only organ whose flow against the angle was measured, on rats and rams. 27.5 % keep a rest of torsion where pain goes at 360 degrees: check the flow. The rest after a whole turn comes from rat ovaries; by how much it helps is not known, and the dose does not count it. Colour is no proof of life. Stiffness, adhesion and fingers are assumed; for training the hand and the order of steps, nothing about one patient.</source>
        <translation>睾丸在精索上转动，与患者体内一样。精索为实心，半径 6 mm，长 60 mm，剪切模量假设为 10 kPa（每弧度 0.34 N mm），没有管壁、管腔和皱褶：通畅度始终为 1。血管：这是唯一测量过血流与扭转角关系的器官，数据来自大鼠和公羊。疼痛在 360 度时即可消失，而 27.5% 的患者仍有残余扭转：应检查血流。每转一整圈后停歇的做法来自大鼠卵巢；效果有多大尚不清楚，缺血剂量不计入。颜色不能证明组织存活。刚度、粘连和手指为假设值；仅用于训练手法和步骤顺序，不能用于判断具体患者。</translation>
    </message>
    <message>
        <source>An omega loop of sigmoid whose two limbs are wrung between the feet on the root and the top in the hand. The top turns as a whole about the line from the root to it; the limbs are wrung and lie wound round each other. That they press on each other adds no torque here, as it would in a patient, and the mesentery is not drawn. The law of the wall was checked for length over radius 3 to 12 and wall over radius 0.03 to 0.1. The limbs are 198 mm long on a mean radius of 32 mm (6.3) with a wall over radius of 0.055 to 0.099: inside. Pressure times radius over stiffness times wall is 3.1 at 15 mmHg, held against a second computation up to 0.5 only. The lumen shuts near 140 degrees; letting gas out takes the peak torque from 131 to 27 N mm. Wall, pressure, stiffness, friction and vessels are assumed; pull and jaw are sourced. Blood flow against the angle was measured on testes only and is carried over. Colour is no proof of life. For training the hand and the order of steps; it says nothing about one patient.</source>
        <translation>一段 Ω 形的乙状结肠袢，两肢在系膜根部的肠脚与手中的袢顶之间被拧转。袢顶作为整体绕根部到袢顶的直线转动；两肢被拧转并相互缠绕。在患者体内两肢会相互挤压而增加力矩，此处不计；系膜未画出。管壁定律在长度与半径之比 3 至 12、壁厚与半径之比 0.03 至 0.1 的范围内验证过。两肢长 198 mm，平均半径 32 mm（比值 6.3），壁厚与半径之比为 0.055 至 0.099：在范围之内。15 mmHg 时压力乘半径除以刚度与壁厚之积为 3.1，而与另一种计算的对照只做到 0.5。肠腔在约 140 度时闭合；排气使最大力矩从 131 降到 27 N mm。壁厚、压力、刚度、摩擦和血管为假设值；牵拉和钳口的限值有文献来源。血流与扭转角的关系只在睾丸上测量过，此处借用。颜色不能证明组织存活。仅用于训练手法和步骤顺序，不能用于判断具体患者。</translation>
    </message>
    <message>
        <source>Rows of the record sealed</source>
        <translation>记录中的行已封存</translation>
    </message>
    <message>
        <source>sealed rows</source>
        <translation>封存的行</translation>
    </message>
    <message>
        <source>backup</source>
        <translation>备份</translation>
    </message>
    <message>
        <source>record before a restore</source>
        <translation>还原之前的记录</translation>
    </message>
    <message>
        <source>record before a new schema</source>
        <translation>数据库结构升级之前的记录</translation>
    </message>
    <message>
        <source>package about the person</source>
        <translation>此人的资料包</translation>
    </message>
    <message>
        <source>Audit trail</source>
        <translation>审计记录</translation>
    </message>
    <message>
        <source>Head of the audit trail</source>
        <translation>审计记录的链头哈希</translation>
    </message>
    <message>
        <source>the column %1 was altered on its way into the record; nothing was kept</source>
        <translation>列 %1 在写入记录途中被改动；未保存任何内容</translation>
    </message>
    <message>
        <source>Run torsio audit verify: a trigger may do this</source>
        <translation>运行 torsio audit verify：可能是触发器所为</translation>
    </message>
    <message>
        <source>seals a change of which the trail does not tell</source>
        <translation>封存了审计记录中没有的更改</translation>
    </message>
    <message>
        <source>belongs to no seal</source>
        <translation>不属于任何封存</translation>
    </message>
    <message>
        <source>is sealed, but this version knows no such table</source>
        <translation>已封存，但此版本不认识该表</translation>
    </message>
    <message>
        <source>its seals were changed</source>
        <translation>其封存已被改动</translation>
    </message>
    <message>
        <source>its seal belongs to no entry</source>
        <translation>其封存不属于任何条目</translation>
    </message>
    <message>
        <source>tells of an erase that did not take place</source>
        <translation>记述了并未发生的抹除</translation>
    </message>
    <message>
        <source>tells of a removal that did not take place</source>
        <translation>记述了并未发生的移除</translation>
    </message>
    <message>
        <source>is there, but was never recorded</source>
        <translation>存在，但从未被记录</translation>
    </message>
    <message>
        <source>differs from what was recorded</source>
        <translation>与所记录的不同</translation>
    </message>
    <message>
        <source>is gone, but what belongs to it is there</source>
        <translation>已不存在，但属于它的内容仍在</translation>
    </message>
    <message>
        <source>was recorded, but is gone</source>
        <translation>曾被记录，但已不存在</translation>
    </message>
    <message>
        <source>its list of schema steps was changed</source>
        <translation>其数据库结构步骤列表已被改动</translation>
    </message>
    <message>
        <source>Close other programs at this station</source>
        <translation>请关闭本站点上的其他程序</translation>
    </message>
    <message>
        <source>the device process ended before it answered</source>
        <translation>设备进程在响应之前已终止</translation>
    </message>
    <message>
        <source>the device&apos;s driver does not answer</source>
        <translation>设备的驱动程序没有响应</translation>
    </message>
    <message>
        <source>signatures</source>
        <translation>签名</translation>
    </message>
    <message>
        <source>Choose 0 to %1 minutes</source>
        <translation>请选择 0 到 %1 分钟</translation>
    </message>
    <message>
        <source>Then try again</source>
        <translation>然后重试</translation>
    </message>
    <message>
        <source>the password is not right</source>
        <translation>密码不正确</translation>
    </message>
    <message>
        <source>a signature asks for your password</source>
        <translation>签名需要输入您的密码</translation>
    </message>
    <message>
        <source>signature</source>
        <translation>签名</translation>
    </message>
    <message>
        <source>Enter your password and submit again</source>
        <translation>请输入密码后再次提交</translation>
    </message>
    <message>
        <source>you asked for this yourself</source>
        <translation>这是您自己提出的申请</translation>
    </message>
    <message>
        <source>whoever asked for this may not sign in any more</source>
        <translation>提出申请的人已不能登录</translation>
    </message>
    <message>
        <source>you asked for this yourself, with another account</source>
        <translation>这是您用另一个账号提出的申请</translation>
    </message>
    <message>
        <source>an account of the demonstration confirms nothing</source>
        <translation>演示账户不能确认任何申请</translation>
    </message>
    <message>
        <source>this is your own account</source>
        <translation>这是您自己的账号</translation>
    </message>
    <message>
        <source>this request is not open any more</source>
        <translation>该申请已不再有效</translation>
    </message>
    <message>
        <source>two people</source>
        <translation>两人共同完成</translation>
    </message>
    <message>
        <source>Let another administrator confirm it</source>
        <translation>请由另一位管理员确认</translation>
    </message>
    <message>
        <source>a request needs a reason</source>
        <translation>申请需要说明理由</translation>
    </message>
    <message>
        <source>Say why, for whoever confirms it and for the audit trail</source>
        <translation>请说明理由，供确认人参考并记入审计记录</translation>
    </message>
    <message>
        <source>Let other administrators ask for it and confirm it</source>
        <translation>请由其他管理员申请和确认</translation>
    </message>
    <message>
        <source>this is asked for already</source>
        <translation>此事已有申请</translation>
    </message>
    <message>
        <source>Let another administrator confirm it, or take the request back first</source>
        <translation>请由另一位管理员确认，或先撤回该申请</translation>
    </message>
    <message>
        <source>this needs two people: one asks for it, another confirms it</source>
        <translation>此事需要两人：一人申请，另一人确认</translation>
    </message>
    <message>
        <source>Ask for it, and let another administrator confirm it under Requests; a small centre can switch this off in its settings</source>
        <translation>请提出申请，并由另一位管理员在“申请”中确认；小型中心可在设置中关闭此规则</translation>
    </message>
    <message>
        <source>Take the request back</source>
        <translation>请撤回该申请</translation>
    </message>
    <message>
        <source>this record belongs to another account</source>
        <translation>该记录属于另一个系统账号</translation>
    </message>
    <message>
        <source>Run the command as its owner, or sign in with --as LOGIN</source>
        <translation>请以其所有者身份运行命令，或用 --as LOGIN 登录</translation>
    </message>
    <message>
        <source>the start password must be changed first</source>
        <translation>必须先更改初始密码</translation>
    </message>
    <message>
        <source>Sign in once in the window, and choose a password of your own</source>
        <translation>请先在窗口中登录一次，并设置自己的密码</translation>
    </message>
    <message>
        <source>sign-in name or password is not right, or the account is disabled</source>
        <translation>登录名或密码不正确，或账号已停用</translation>
    </message>
    <message>
        <source>Give --as LOGIN, or --as-system as the owner of the record</source>
        <translation>请给出 --as LOGIN，或以记录所有者身份使用 --as-system</translation>
    </message>
    <message>
        <source>an SQLite file has no roles of its own</source>
        <translation>SQLite 文件没有自己的角色</translation>
    </message>
    <message>
        <source>Name the address of a PostgreSQL server</source>
        <translation>请给出 PostgreSQL 服务器的地址</translation>
    </message>
    <message>
        <source>this account does not own the tables of the record</source>
        <translation>此账号不是记录中各表的所有者</translation>
    </message>
    <message>
        <source>Connect as the owner</source>
        <translation>请以所有者身份连接</translation>
    </message>
    <message>
        <source>Two people for passwords, roles, erasing, restoring and the allocation</source>
        <translation>密码、角色、删除、恢复与启封分组须两人共同完成</translation>
    </message>
    <message>
        <source>needed</source>
        <translation>需要</translation>
    </message>
    <message>
        <source>switched off by the centre</source>
        <translation>已由中心关闭</translation>
    </message>
    <message>
        <source>Marks signed with a password</source>
        <translation>以密码签名的评分</translation>
    </message>
    <message>
        <source>Signature of the frozen data set</source>
        <translation>冻结数据集的签名</translation>
    </message>
    <message>
        <source>Roles of the server written</source>
        <translation>写入服务器角色</translation>
    </message>
    <message>
        <source>Second person asked for</source>
        <translation>申请第二人确认</translation>
    </message>
    <message>
        <source>Confirmed by a second person</source>
        <translation>已由第二人确认</translation>
    </message>
    <message>
        <source>Request declined or taken back</source>
        <translation>申请被拒绝或撤回</translation>
    </message>
    <message>
        <source>Signed</source>
        <translation>签名</translation>
    </message>
    <message>
        <source>request</source>
        <translation>申请</translation>
    </message>
    <message>
        <source>New start password</source>
        <translation>新的初始密码</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>角色</translation>
    </message>
    <message>
        <source>Erase a person</source>
        <translation>删除一名人员</translation>
    </message>
    <message>
        <source>Restore a backup</source>
        <translation>恢复备份</translation>
    </message>
    <message>
        <source>Open the allocation</source>
        <translation>启封随机分组</translation>
    </message>
    <message>
        <source>One person is enough from now on</source>
        <translation>今后一人即可</translation>
    </message>
    <message>
        <source>confirmed</source>
        <translation>已确认</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>已拒绝</translation>
    </message>
    <message>
        <source>I scored this case</source>
        <translation>我已为此案例评分</translation>
    </message>
    <message>
        <source>I changed my mark of this case</source>
        <translation>我已更改对此案例的评分</translation>
    </message>
    <message>
        <source>I froze these data</source>
        <translation>我已冻结这些数据</translation>
    </message>
    <message>
        <source>an address does not hold the parameter %1</source>
        <translation>地址中不能包含参数 %1</translation>
    </message>
    <message>
        <source>Write the password to the password file of your account (~/.pgpass)</source>
        <translation>请将密码写入您账号的密码文件（~/.pgpass）</translation>
    </message>
    <message>
        <source>unknown connection parameter %1</source>
        <translation>未知的连接参数 %1</translation>
    </message>
    <message>
        <source>Known are schema, %1</source>
        <translation>已知参数有 schema、%1</translation>
    </message>
    <message>
        <source>connection parameter %1 has no value</source>
        <translation>连接参数 %1 没有值</translation>
    </message>
    <message>
        <source>Give it one, or leave it out</source>
        <translation>请给出其值，或将其省略</translation>
    </message>
    <message>
        <source>the value of connection parameter %1 cannot be used</source>
        <translation>连接参数 %1 的值不可用</translation>
    </message>
    <message>
        <source>Choose a name or a path without semicolons and line breaks</source>
        <translation>请选择不含分号和换行的名称或路径</translation>
    </message>
    <message>
        <source>sslmode cannot be %1</source>
        <translation>sslmode 不能为 %1</translation>
    </message>
    <message>
        <source>Choose one of %1</source>
        <translation>请选择其中之一：%1</translation>
    </message>
    <message>
        <source>connection parameter %1 is given twice</source>
        <translation>连接参数 %1 重复给出</translation>
    </message>
    <message>
        <source>Leave one out</source>
        <translation>请去掉其中一个</translation>
    </message>
    <message>
        <source>Write it as postgresql://user@host:port/database?sslmode=verify-full</source>
        <translation>请写成 postgresql://user@host:port/database?sslmode=verify-full</translation>
    </message>
    <message>
        <source>this cannot be the role of the stations</source>
        <translation>此名称不能作为工作站角色</translation>
    </message>
    <message>
        <source>Take a name of lower-case letters, digits and underscores that is not the owner&apos;s</source>
        <translation>请使用由小写字母、数字和下划线组成、且不同于所有者的名称</translation>
    </message>
    <message>
        <source>Able on the simulator</source>
        <translation>模拟器上已胜任</translation>
    </message>
    <message>
        <source>Torsio</source>
        <translation>Torsio</translation>
    </message>
    <message>
        <source>Demonstration</source>
        <translation>演示数据</translation>
    </message>
    <message>
        <source>People, movements and marks are simulated.</source>
        <translation>人员、动作和评分均为模拟数据。</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>All times are UTC.</source>
        <translation>所有时间均为 UTC。</translation>
    </message>
    <message>
        <source>Pseudonymised</source>
        <translation>已假名化</translation>
    </message>
    <message>
        <source>Names of people and recordings are opaque; times of each person are moved by whole days.</source>
        <translation>人员和记录使用不可识别的名称；每个人的时间均按整天平移。</translation>
    </message>
    <message>
        <source>Group, sex and level are shared by at least %1 people (%2 before).</source>
        <translation>组别、性别和培训阶段相同者至少 %1 人（处理前 %2 人）。</translation>
    </message>
    <message>
        <source>nobody has a score that may be shown</source>
        <translation>尚无可以显示的得分</translation>
    </message>
    <message>
        <source>Wait until every sheet is in, or freeze the data</source>
        <translation>请等待所有评分表交齐，或冻结数据</translation>
    </message>
    <message>
        <source>Time in the exercise</source>
        <translation>练习时间</translation>
    </message>
    <message>
        <source>Twists not completed</source>
        <translation>未完成的扭转</translation>
    </message>
    <message>
        <source>Twists released on target</source>
        <translation>达标释放</translation>
    </message>
    <message>
        <source>Mean absolute error of the angle</source>
        <translation>角度平均绝对误差</translation>
    </message>
    <message>
        <source>Peak torque</source>
        <translation>最大扭矩</translation>
    </message>
    <message>
        <source>Peak force on the tissue</source>
        <translation>组织受力峰值</translation>
    </message>
    <message>
        <source>Peak force of the device</source>
        <translation>设备输出的最大力</translation>
    </message>
    <message>
        <source>Samples that were refused</source>
        <translation>被拒绝的采样</translation>
    </message>
    <message>
        <source>Pauses without force</source>
        <translation>无力暂停次数</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>模型评价</translation>
    </message>
    <message>
        <source>Evaluation of the tissue models by Eqs. 25 to 27</source>
        <translation>按式 25 至 27 对组织模型的评价</translation>
    </message>
    <message>
        <source>Agreement</source>
        <translation>一致性</translation>
    </message>
    <message>
        <source>Agreement of the raters on the marks of the training study</source>
        <translation>培训研究中各评分者评分的一致性</translation>
    </message>
    <message>
        <source>Comparison of the groups on the scores of the training study</source>
        <translation>培训研究得分的组间比较</translation>
    </message>
    <message>
        <source>Number of the occasion</source>
        <translation>评分时点序号</translation>
    </message>
    <message>
        <source>Scores</source>
        <translation>得分</translation>
    </message>
    <message>
        <source>Mean of the raters&apos; marks of a trainee at an occasion</source>
        <translation>学员在某一评分时点所得各评分者评分的平均值</translation>
    </message>
    <message>
        <source>Sex</source>
        <translation>性别</translation>
    </message>
    <message>
        <source>Level of training</source>
        <translation>培训阶段</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>得分</translation>
    </message>
    <message>
        <source>Marks behind it</source>
        <translation>评分个数</translation>
    </message>
    <message>
        <source>Newest version of each mark that a rater submitted</source>
        <translation>每位评分者所提交评分的最新版本</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>评分</translation>
    </message>
    <message>
        <source>Number of the run</source>
        <translation>操作序号</translation>
    </message>
    <message>
        <source>Tissue model</source>
        <translation>组织模型</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>是否中断</translation>
    </message>
    <message>
        <source>Started (UTC)</source>
        <translation>开始时间（UTC）</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Hash of the recording</source>
        <translation>记录的哈希值</translation>
    </message>
    <message>
        <source>Metrics of each recorded run, measured again from its samples</source>
        <translation>由采样重新测得的各次操作指标</translation>
    </message>
    <message>
        <source>Learning curves</source>
        <translation>学习曲线</translation>
    </message>
    <message>
        <source>Absolute error of each completed twist when the jaw was opened, in its order</source>
        <translation>每次完成的扭转在松开钳口时的绝对误差，按先后顺序</translation>
    </message>
    <message>
        <source>Number of the twist</source>
        <translation>扭转序号</translation>
    </message>
    <message>
        <source>Error of the angle</source>
        <translation>角度误差</translation>
    </message>
    <message>
        <source>Verdict of the registered competence design, with both error rates</source>
        <translation>按已登记的胜任判定方案得出的结论及其两类错误率</translation>
    </message>
    <message>
        <source>Level reached</source>
        <translation>达到的等级</translation>
    </message>
    <message>
        <source>Failed attempts</source>
        <translation>未达标次数</translation>
    </message>
    <message>
        <source>Able</source>
        <translation>胜任</translation>
    </message>
    <message>
        <source>Able at attempt</source>
        <translation>达到胜任的次数</translation>
    </message>
    <message>
        <source>Probability of a false pass</source>
        <translation>误判通过的概率</translation>
    </message>
    <message>
        <source>Probability of a false fail</source>
        <translation>误判不通过的概率</translation>
    </message>
    <message>
        <source>Version of the design</source>
        <translation>方案版本</translation>
    </message>
    <message>
        <source>Statistic</source>
        <translation>统计量</translation>
    </message>
    <message>
        <source>Values used</source>
        <translation>使用的数值个数</translation>
    </message>
    <message>
        <source>Protocol deviations</source>
        <translation>方案偏离</translation>
    </message>
    <message>
        <source>What did not go by the protocol, as it was noted</source>
        <translation>已记录的不符合方案的情况</translation>
    </message>
    <message>
        <source>Happened (UTC)</source>
        <translation>发生时间（UTC）</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>说明</translation>
    </message>
    <message>
        <source>All numbers</source>
        <translation>全部数值</translation>
    </message>
    <message>
        <source>Every line of cohort.csv; a spreadsheet keeps 15 digits, the text all of them</source>
        <translation>cohort.csv 的每一行；电子表格保留 15 位数字，文本保留全部位数</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>部分</translation>
    </message>
    <message>
        <source>Trainee, rater or all</source>
        <translation>学员、评分者或全部</translation>
    </message>
    <message>
        <source>Value as text</source>
        <translation>数值文本</translation>
    </message>
    <message>
        <source>the key of the pseudonyms is too short</source>
        <translation>假名化密钥过短</translation>
    </message>
    <message>
        <source>Take at least 32 characters, or none for a new key</source>
        <translation>请使用至少 32 个字符，或留空以生成新密钥</translation>
    </message>
    <message>
        <source>the table does not fit an SPSS file</source>
        <translation>该表无法存入 SPSS 文件</translation>
    </message>
    <message>
        <source>there is no such format of tables</source>
        <translation>没有这种表格格式</translation>
    </message>
    <message>
        <source>Take csv, r or spss</source>
        <translation>请选择 csv、r 或 spss</translation>
    </message>
    <message>
        <source>Overview</source>
        <translation>概览</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>图</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>工作表</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Name for programs</source>
        <translation>程序用名称</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Where it comes from</source>
        <translation>数据来源</translation>
    </message>
    <message>
        <source>the workbook cannot be written</source>
        <translation>无法写入工作簿</translation>
    </message>
    <message>
        <source>Look for free space and the rights of the folder</source>
        <translation>请检查可用空间和文件夹权限</translation>
    </message>
    <message>
        <source>lower whisker</source>
        <translation>下须</translation>
    </message>
    <message>
        <source>lower quartile</source>
        <translation>下四分位数</translation>
    </message>
    <message>
        <source>median</source>
        <translation>中位数</translation>
    </message>
    <message>
        <source>upper quartile</source>
        <translation>上四分位数</translation>
    </message>
    <message>
        <source>upper whisker</source>
        <translation>上须</translation>
    </message>
    <message>
        <source>median less lower quartile</source>
        <translation>中位数减下四分位数</translation>
    </message>
    <message>
        <source>upper quartile less median</source>
        <translation>上四分位数减中位数</translation>
    </message>
    <message>
        <source>lower quartile to median</source>
        <translation>下四分位数至中位数</translation>
    </message>
    <message>
        <source>median to upper quartile</source>
        <translation>中位数至上四分位数</translation>
    </message>
    <message>
        <source>category</source>
        <translation>类别</translation>
    </message>
    <message>
        <source>has no column %1 any more</source>
        <translation>不再有列 %1</translation>
    </message>
    <message>
        <source>a purpose has no title or no text</source>
        <translation>有一项用途缺少标题或正文</translation>
    </message>
    <message>
        <source>Fill both in, in every language</source>
        <translation>请在每种语言中填写两者</translation>
    </message>
    <message>
        <source>there is no language</source>
        <translation>没有任何语言</translation>
    </message>
    <message>
        <source>the training record is not asked about</source>
        <translation>没有征求对训练记录的同意</translation>
    </message>
    <message>
        <source>Keep this purpose: without it nothing may be recorded</source>
        <translation>请保留此项用途：没有它就不能记录任何内容</translation>
    </message>
    <message>
        <source>a purpose is asked about twice</source>
        <translation>同一用途出现了两次</translation>
    </message>
    <message>
        <source>a language has no name, or comes twice</source>
        <translation>有一种语言没有名称，或出现了两次</translation>
    </message>
    <message>
        <source>Name each language once</source>
        <translation>每种语言只列出一次</translation>
    </message>
    <message>
        <source>the languages do not ask about the same purposes</source>
        <translation>各语言所征求的用途不一致</translation>
    </message>
    <message>
        <source>Ask about the same purposes in the same order</source>
        <translation>请按相同顺序征求相同的用途</translation>
    </message>
    <message>
        <source>the consent texts have no language</source>
        <translation>知情同意文本没有任何语言</translation>
    </message>
    <message>
        <source>it is not said what changed</source>
        <translation>没有说明改动了什么</translation>
    </message>
    <message>
        <source>Say it in a few words</source>
        <translation>请用几个字说明</translation>
    </message>
    <message>
        <source>nothing has changed</source>
        <translation>没有任何改动</translation>
    </message>
    <message>
        <source>Change a text first</source>
        <translation>请先修改文本</translation>
    </message>
    <message>
        <source>the day of the signature is still to come</source>
        <translation>签名日期尚未到来</translation>
    </message>
    <message>
        <source>Enter the day that stands on the paper</source>
        <translation>请输入纸上所写的日期</translation>
    </message>
    <message>
        <source>the pages cannot be given bookmarks: %1 is missing</source>
        <translation>无法为页面添加书签：缺少 %1</translation>
    </message>
    <message>
        <source>report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Write the report again</source>
        <translation>请重新生成报告</translation>
    </message>
    <message>
        <source>Report %1  |  numbers %2
audit trail %3</source>
        <translation>报告 %1  |  数值 %2
审计追踪 %3</translation>
    </message>
    <message>
        <source>another cohort has this name</source>
        <translation>另一批次已使用此名称</translation>
    </message>
    <message>
        <source>the cohort is %1 and cannot become %2</source>
        <translation>该批次的状态是 %1，不能变为 %2</translation>
    </message>
    <message>
        <source>Close a running cohort, archive a closed one, or open it again</source>
        <translation>请关闭进行中的批次、归档已关闭的批次，或重新开放</translation>
    </message>
    <message>
        <source>somebody of this cohort is training</source>
        <translation>该批次有人正在训练</translation>
    </message>
    <message>
        <source>Wait for the end of the run, or close what was cut off at its station</source>
        <translation>请等待训练结束，或在其工位关闭中断的训练</translation>
    </message>
    <message>
        <source>%1 sheets are still open</source>
        <translation>仍有 %1 份评分表未完成</translation>
    </message>
    <message>
        <source>Wait for them, or take them back under Scoring</source>
        <translation>请等待其完成，或在“评分”中收回</translation>
    </message>
    <message>
        <source>it is not said why</source>
        <translation>没有说明原因</translation>
    </message>
    <message>
        <source>this cohort is closed</source>
        <translation>该批次已关闭</translation>
    </message>
    <message>
        <source>Choose another cohort, or have an administrator open it again</source>
        <translation>请选择其他批次，或请管理员重新开放</translation>
    </message>
    <message>
        <source>no row has a weight</source>
        <translation>没有任何一行有权重</translation>
    </message>
    <message>
        <source>Give at least one criterion a weight above 0</source>
        <translation>请至少给一个评分项大于 0 的权重</translation>
    </message>
    <message>
        <source>a weight is out of range</source>
        <translation>权重超出范围</translation>
    </message>
    <message>
        <source>Use 0 to 100</source>
        <translation>请使用 0 到 100</translation>
    </message>
    <message>
        <source>Consent texts published</source>
        <translation>发布知情同意文本</translation>
    </message>
    <message>
        <source>Cohort renamed</source>
        <translation>批次改名</translation>
    </message>
    <message>
        <source>Cohort closed, archived or opened again</source>
        <translation>批次关闭、归档或重新开放</translation>
    </message>
    <message>
        <source>consent texts</source>
        <translation>知情同意文本</translation>
    </message>
    <message>
        <source>on the screen</source>
        <translation>在屏幕上</translation>
    </message>
    <message>
        <source>on paper</source>
        <translation>在纸上</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Hash of the table of numbers</source>
        <translation>数值表的哈希值</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>草稿</translation>
    </message>
    <message>
        <source>archived</source>
        <translation>已归档</translation>
    </message>
    <message>
        <source>The header promises %1 {marker|markers}, the line has more</source>
        <translation>文件头写明有 %1 个标记点，但该行更多</translation>
    </message>
    <message>
        <source>The line has more columns than %1 {marker|markers}</source>
        <translation>该行的列数多于 %1 个标记点所需</translation>
    </message>
    <message>
        <source>The header promises %1 {frame|frames}, the file has %2</source>
        <translation>文件头写明有 %1 帧，文件中有 %2 帧</translation>
    </message>
    <message>
        <source>%1 of %2 {frame|frames} gave a valid position, %3 {was|were} refused</source>
        <translation>%2 帧中有 %1 帧给出有效位置，%3 帧被拒绝</translation>
    </message>
    <message>
        <source>the library took %1 {frame|frames} with force and refused %2</source>
        <translation>厂商库接受了 %1 帧带力的数据，拒绝了 %2 帧</translation>
    </message>
    <message>
        <source>the machine was too busy: the force was cut %1 {time|times}, %2 of %3 {tick was|ticks were} skipped</source>
        <translation>计算机过于繁忙：力中断 %1 次，%3 个周期中有 %2 个被跳过</translation>
    </message>
    <message>
        <source>run %1</source>
        <translation>操作 %1</translation>
    </message>
    <message>
        <source>an age of %1 {year|years} is not likely</source>
        <translation>年龄 %1 岁不大可能</translation>
    </message>
    <message>
        <source>the line has %1 {value|values}, the header %2</source>
        <translation>该行有 %1 个值，标题行有 %2 个</translation>
    </message>
    <message>
        <source>%1 {person of this cohort has|people of this cohort have} a finished run at this exercise; %2 {is|are} needed</source>
        <translation>该批次中有 %1 人在这个练习上有完成的操作；需要 %2 人</translation>
    </message>
    <message>
        <source>a twist released within %1 {degree|degrees} (tolerance %2)</source>
        <translation>松开时误差在 %1 度以内的一次扭转（容差%2）</translation>
    </message>
    <message>
        <source>%1: success is %2; able once the LC-CUSUM of failure rates %3 against %4 reaches %5, planned for %6 {attempt|attempts}.</source>
        <translation>%1：成功指%2；失败率 %3 对 %4 的 LC-CUSUM 达到 %5 即为胜任，按 %6 次尝试设计。</translation>
    </message>
    <message>
        <source>not shown yet, %1 {attempt|attempts} missing</source>
        <translation>尚未显示，还差 %1 次尝试</translation>
    </message>
    <message>
        <source>no run has this id</source>
        <translation>没有此编号的操作</translation>
    </message>
    <message>
        <source>several runs begin like this</source>
        <translation>有多个操作以此开头</translation>
    </message>
    <message>
        <source>asks for %1 in a row, but only %2 {attempt is|attempts are} allowed</source>
        <translation>要求连续 %1 次，但只允许 %2 次</translation>
    </message>
    <message>
        <source>Invite raters under Scoring</source>
        <translation>请在“评分”页邀请评分者</translation>
    </message>
    <message>
        <source>today&apos;s sessions</source>
        <translation>今日训练</translation>
    </message>
    <message>
        <source>Call the trainee on the page Today&apos;s sessions first</source>
        <translation>请先在“今日训练”页面呼叫该学员</translation>
    </message>
    <message>
        <source>%1 of %2 {sheet is|sheets are} not submitted</source>
        <translation>%2 份评分表中有 %1 份尚未提交</translation>
    </message>
    <message>
        <source>a question needs words</source>
        <translation>提问需要文字</translation>
    </message>
    <message>
        <source>Write what you want to know</source>
        <translation>请写下您想了解的内容</translation>
    </message>
    <message>
        <source>sheets of the occasion &quot;%3&quot; that are in: %1 of %2</source>
        <translation>评分时点“%3”的 %2 份评分表已收到 %1 份</translation>
    </message>
    <message>
        <source>run</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>%1 of the adequate trainees would not pass within %2 {attempt|attempts}; at most %3 are wanted</source>
        <translation>%1 的胜任者在 %2 次尝试内不会通过；最多允许 %3</translation>
    </message>
    <message>
        <source>Run begun</source>
        <translation>开始操作</translation>
    </message>
    <message>
        <source>Run stopped</source>
        <translation>停止操作</translation>
    </message>
    <message>
        <source>Chi-squared(%1) = %2, %3; Kendall W = %4 over %5 {rater|raters}.</source>
        <translation>χ²(%1) = %2，%3；%5 名评分者的 Kendall W = %4。</translation>
    </message>
    <message>
        <source>People: %1 {trainee|trainees} in %2 {group|groups}, %3 of them withdrew; %4 {physician|physicians} gave %5 {mark|marks}; %6 {deviation from the protocol was|deviations from the protocol were} reported.</source>
        <translation>人员：%1 名学员分为 %2 组，其中 %3 名退出；%4 名医师给出 %5 个分数；报告了 %6 次方案偏离。</translation>
    </message>
    <message>
        <source>a run is in a group that does not exist</source>
        <translation>某次操作所在的组不存在</translation>
    </message>
    <message>
        <source>No test of baseline differences is shown. %1 {trainee was|trainees were} moved by hand after the draw: a difference need not be due to chance.</source>
        <translation>不显示基线差异的检验。抽取之后有 %1 名学员被人工调组：差异不一定出于偶然。</translation>
    </message>
    <message>
        <source>Interrupted runs</source>
        <translation>中断的操作</translation>
    </message>
    <message>
        <source>Recorded runs by group and phase</source>
        <translation>各组、各阶段已录制的操作</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>操作次数</translation>
    </message>
    <message>
        <source>Means are taken over runs. Measured by the simulator; the marks of the physicians are separate.</source>
        <translation>按操作次数取均值。由模拟器测得；医师的评分另计。</translation>
    </message>
    <message>
        <source>means over runs</source>
        <translation>各次操作的均值</translation>
    </message>
    <message>
        <source>%1 {trainee was|trainees were} allocated to %2 {group|groups}; %3 more {was enrolled and is|were enrolled and are} in no group</source>
        <translation>%1 名学员被随机分入 %2 组；另有 %3 名已登记但尚未分组</translation>
    </message>
    <message>
        <source>%1 {trainee was|trainees were} allocated to %2 {group|groups}</source>
        <translation>%1 名学员被随机分入 %2 组</translation>
    </message>
    <message>
        <source>%1 {deviation from the protocol was|deviations from the protocol were} reported: %2.</source>
        <translation>共报告 %1 次方案偏离：%2。</translation>
    </message>
    <message>
        <source>%1 {run was|runs were} recorded, %2 {minute|minutes} and %3 {sample|samples} in all; samples not recorded: %4; late ticks: %5.</source>
        <translation>共记录 %1 次操作，合计 %2 分钟、%3 个采样；未记录的采样：%4；超时周期：%5。</translation>
    </message>
    <message>
        <source>The machine was too busy in runs: %1. Their force was cut for a moment, times in all: %2; they are marked in the data.</source>
        <translation>计算机过于繁忙的操作：%1 次。其间力共短暂中断 %2 次；这些操作已在数据中标明。</translation>
    </message>
    <message>
        <source>Runs with samples that were not recorded are incomplete and marked in the data.</source>
        <translation>有采样未记录的操作不完整，已在数据中标明。</translation>
    </message>
    <message>
        <source>%1 {entry|entries} at %2</source>
        <translation>%2 时共 %1 条</translation>
    </message>
    <message>
        <source>medians over runs</source>
        <translation>各次操作的中位数</translation>
    </message>
    <message>
        <source>The evaluation is not finished: %1 {mark is|marks are} in so far. Scores are computed once every class of raters that has a weight has scored every index of every model.</source>
        <translation>评价尚未完成：目前已收到 %1 个评分。待每个有权重的评分者类别对每个模型的每项指标都评过分后，才计算得分。</translation>
    </message>
    <message>
        <source>The first points rest on up to %1 {trainee|trainees} of a group, the last on %2.</source>
        <translation>最初的点基于每组至多 %1 名学员，最后的点基于 %2 名。</translation>
    </message>
    <message>
        <source>%1 of %2 {mark of the first and the last occasion is|marks of the first and the last occasion are} missing</source>
        <translation>首末两个评分时点的 %2 个评分中缺失 %1 个</translation>
    </message>
    <message>
        <source>Mark at the end on group and mean mark before (fixed), trainee and rater (random, crossed); %1 {mark|marks} of %2 {trainee|trainees}. Degrees of freedom after Satterthwaite.</source>
        <translation>结束时评分对组别和训练前平均评分（固定效应）、学员和评分者（随机、交叉）建模；%2 名学员的 %1 个评分。自由度按 Satterthwaite 法。</translation>
    </message>
    <message>
        <source>Learning; Recorded runs</source>
        <translation>学习过程；已录制的操作</translation>
    </message>
    <message>
        <source>Every recording is sealed in the record by its content hash; it can be replayed and compared bit for bit (torsio replay RUN --verify).</source>
        <translation>每份录制都以内容哈希封存在记录中；可以重放并逐位比较（torsio replay RUN --verify）。</translation>
    </message>
    <message>
        <source>%1 {recording has|recordings have} no content hash: nothing shows that {it is|they are} unchanged.</source>
        <translation>%1 份录制没有内容哈希：无法表明它们未被更改。</translation>
    </message>
    <message>
        <source>%1 {mark could not be given and carries a reason; it counts|marks could not be given and carry a reason; they count} as missing.</source>
        <translation>有 %1 个评分无法给出并注明了理由；按缺失处理。</translation>
    </message>
    <message>
        <source>Recordings (first eight digits of the run)</source>
        <translation>录制（操作编号的前八位）</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>操作编号</translation>
    </message>
    <message>
        <source>Raters were blinded: all marks of the training study (%1) were given on recordings under a case label, without name, group or occasion.</source>
        <translation>评分者处于盲态：训练研究的全部 %1 个评分都是在只有案例标签的录制上给出的，不显示姓名、组别和时点。</translation>
    </message>
    <message>
        <source>Raters were not blinded: all marks of the training study (%1) were given live at the real arm, where the rater sees the trainee.</source>
        <translation>评分者未处于盲态：训练研究的全部 %1 个评分都是在实物手臂旁现场给出的，评分者看得到学员。</translation>
    </message>
    <message>
        <source>Nothing shows that raters were blinded: all marks of the training study (%1) were entered without a sheet of the desk.</source>
        <translation>没有任何依据表明评分者处于盲态：训练研究的全部 %1 个评分都不是通过评分台的评分表录入的。</translation>
    </message>
    <message>
        <source>Raters were blinded in part: of %1 {mark|marks} of the training study %2 {was|were} given on recordings under a case label, %3 live at the real arm, where the rater sees the trainee, and %4 {was|were} entered without a sheet of the desk.</source>
        <translation>评分者部分处于盲态：训练研究的 %1 个评分中，%2 个是在只有案例标签的录制上给出的，%3 个是在实物手臂旁现场给出的（评分者看得到学员），%4 个不是通过评分台的评分表录入的。</translation>
    </message>
    <message>
        <source>All models (%1) stood before their raters under hidden labels.</source>
        <translation>全部 %1 个模型都以隐藏标签呈现给评分者。</translation>
    </message>
    <message>
        <source>%1 of %2 {model|models} stood before their raters under hidden labels.</source>
        <translation>%2 个模型中有 %1 个以隐藏标签呈现给评分者。</translation>
    </message>
    <message>
        <source>%1 {trainee of this cohort is a rater|trainees of this cohort are raters} of the models as well: their marks are not independent of their training.</source>
        <translation>该批次中有 %1 名学员同时是模型的评分者：他们的评分与其训练并不独立。</translation>
    </message>
    <message>
        <source>Commitment to the seed: %1, made %2, after %3 {trainee|trainees} had been allocated.</source>
        <translation>对种子的承诺：%1，作出于 %2，当时已有 %3 名学员分组。</translation>
    </message>
    <message>
        <source>Commitment to the seed: %1, made %2, before anybody was allocated and after %3 {trainee|trainees} had been enrolled.</source>
        <translation>对种子的承诺：%1，作出于 %2，在任何人分组之前、%3 名学员入组之后。</translation>
    </message>
    <message>
        <source>%1 {physician|physicians} scored every trainee at %2 {occasion|occasions} on a scale from %3 to %4. A trainee&apos;s score is the plain mean of these marks.</source>
        <translation>%1 名医师在 %2 个评分时点按 %3 至 %4 分对每名学员评分。学员得分为这些评分的算术平均值。</translation>
    </message>
    <message>
        <source>%1 {physician|physicians} gave %2 {mark|marks} at %3 {occasion|occasions} on a scale from %4 to %5; not every physician scored every trainee at every occasion. A trainee&apos;s score is the plain mean of the marks at hand.</source>
        <translation>%1 名医师在 %3 个时点以 %4 到 %5 的量表给出 %2 个评分；并非每名医师在每个时点都给每名学员评了分。学员的得分为现有评分的简单平均。</translation>
    </message>
    <message>
        <source>The training study is not shown: %1 of %2 {sheet that raters were asked for is|sheets that raters were asked for are} present. Marks and means appear once all are, or once the data set is frozen.</source>
        <translation>训练研究未显示：要求评分者提交的 %2 份评分表中已有 %1 份。全部提交或数据集冻结之后，才显示评分和均值。</translation>
    </message>
    <message>
        <source>The evaluation of the models is not shown: %1 of %2 {rater who was asked has|raters who were asked have} given all marks. Marks and scores appear once all have, or once the data set is frozen.</source>
        <translation>模型评价未显示：被要求评分的 %2 名评分者中有 %1 名已给出全部评分。全部给出或数据集冻结之后，才显示评分和得分。</translation>
    </message>
    <message>
        <source>Training was shortened for this demonstration: %1 {minute|minutes} of simulated exercise stand for %2 {minute|minutes} of the protocol (1 : %3).</source>
        <translation>本演示缩短了训练：%1 分钟的模拟练习代表方案中的 %2 分钟（1 : %3）。</translation>
    </message>
    <message>
        <source>%1: %2 {day|days}</source>
        <translation>%1：%2 天</translation>
    </message>
    <message>
        <source>real data use the demonstration: %1 {row refers|rows refer} from %2 to simulated rows of %3</source>
        <translation>真实数据使用了演示数据：%2 的 %1 行引用了 %3 的模拟行</translation>
    </message>
    <message>
        <source>the table %1 differs after copying (%2 {row|rows} before, %3 after); nothing was kept</source>
        <translation>表 %1 复制后不一致（之前 %2 行，之后 %3 行）；未保留任何内容</translation>
    </message>
    <message>
        <source>its audit trail does not verify (%1 {finding|findings})</source>
        <translation>其审计记录未通过校验（%1 处）</translation>
    </message>
    <message>
        <source>this rater calibration</source>
        <translation>该次评分校准</translation>
    </message>
    <message>
        <source>no such run</source>
        <translation>没有该操作</translation>
    </message>
    <message>
        <source>List the runs to find its id</source>
        <translation>请列出操作以查找编号</translation>
    </message>
    <message>
        <source>tick period %1 us, latency %2 {tick|ticks}</source>
        <translation>节拍周期 %1 微秒，延迟 %2 个节拍</translation>
    </message>
    <message>
        <source>a recorded run</source>
        <translation>一次已记录的操作</translation>
    </message>
    <message>
        <source>M12 %1 {edge|edges} shared by more than two faces, first at %2</source>
        <translation>M12 有 %1 条边由两个以上的面共用，首个位于 %2</translation>
    </message>
    <message>
        <source>M11 the surface is open: %1 boundary {edge|edges} in %2 {hole|holes}, first at %3</source>
        <translation>M11 曲面未封闭：%2 个孔洞中有 %1 条边界边，首个位于 %3</translation>
    </message>
    <message>
        <source>M12 %1 {vertex|vertices} where two parts only touch, first at %2</source>
        <translation>M12 有 %1 个顶点处两部分仅点接触，首个位于 %2</translation>
    </message>
    <message>
        <source>M10 %1 {face|faces} without area could not be repaired</source>
        <translation>M10 有 %1 个零面积的面无法修复</translation>
    </message>
    <message>
        <source>M16 the surface has %1 {handle|handles}, like a ring</source>
        <translation>M16 曲面有 %1 个环柄，形如圆环</translation>
    </message>
    <message>
        <source>M04 the header promises %1, but the file has %2 {byte|bytes}</source>
        <translation>M04 文件头声明 %1，但文件只有 %2 字节</translation>
    </message>
    <message>
        <source>the surface crosses itself in %1 {pair|pairs} of triangles</source>
        <translation>表面有 %1 对三角形相互穿过</translation>
    </message>
    <message>
        <source>%1 {element|elements} asked for; a rod takes 2 to %2</source>
        <translation>要求 %1 个单元；杆模型可取 2 至 %2 个</translation>
    </message>
    <message>
        <source>Forearm: supinate to 60 degrees, tighter tolerance</source>
        <translation>前臂：旋后 60 度（容差更小）</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>this station keeps no heads</source>
        <translation>本站不保存链头</translation>
    </message>
    <message>
        <source>Choose a witness file first</source>
        <translation>请先选择见证文件</translation>
    </message>
    <message>
        <source>Signatures of the marks</source>
        <translation>评分的签名</translation>
    </message>
    <message>
        <source>Who signed which mark</source>
        <translation>各评分由谁签名</translation>
    </message>
    <message>
        <source>Signed by</source>
        <translation>签名人</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>含义</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>a station may not remove rows from this server, the demonstration neither</source>
        <translation>工作站不能从此服务器删除数据行，演示数据也不能</translation>
    </message>
    <message>
        <source>Start Torsio once with the account that owns the database, and remove it there</source>
        <translation>请用数据库所有者的账户启动一次 Torsio，并在其中删除</translation>
    </message>
    <message>
        <source>a margin of equivalence lies above 0 and is at most %1 points</source>
        <translation>等效界值应大于 0 且不超过 %1 分</translation>
    </message>
    <message>
        <source>Enter the largest difference that does not matter, or none</source>
        <translation>请填写无关紧要的最大差异，或不填</translation>
    </message>
    <message>
        <source>%1 &quot;%2&quot; stands a second time, first in %3</source>
        <translation>%1“%2”第二次出现，首次见于 %3</translation>
    </message>
    <message>
        <source>Keep one row for each %1</source>
        <translation>每个 %1 只保留一行</translation>
    </message>
    <message>
        <source>judge &quot;%1&quot; judges item &quot;%2&quot; a second time, first in %3</source>
        <translation>评判者“%1”第二次评判项目“%2”，首次见于 %3</translation>
    </message>
    <message>
        <source>Keep one percentage for each judge and item</source>
        <translation>每位评判者对每个项目只保留一个百分比</translation>
    </message>
    <message>
        <source>judge &quot;%1&quot; has no percentage for item &quot;%2&quot;</source>
        <translation>评判者“%1”没有给出项目“%2”的百分比</translation>
    </message>
    <message>
        <source>Every judge judges every item</source>
        <translation>每位评判者都要评判每个项目</translation>
    </message>
    <message>
        <source>the percentage %1 lies outside 0 to 100</source>
        <translation>百分比 %1 不在 0 到 100 之间</translation>
    </message>
    <message>
        <source>Give the chance of a borderline trainee in percent</source>
        <translation>请以百分比给出处于及格边缘的学员成功的可能性</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no group of this method</source>
        <translation>“%1”不是该方法的组别</translation>
    </message>
    <message>
        <source>Write novice or master</source>
        <translation>请写 novice（新手）或 master（熟练者）</translation>
    </message>
    <message>
        <source>The intervals take scores for normal. Of strongly skewed scores they hold the true coefficient in about four of five cases, not in 95 %.</source>
        <translation>这些区间以得分呈正态分布为前提。得分明显偏态时，区间包含真实系数的情况约为五分之四，而不是 95 %。</translation>
    </message>
    <message>
        <source>No margin was planned within which a difference would not matter. Nothing here shows that groups are equal, however far a difference is from significant.</source>
        <translation>研究计划没有规定多大的差异无关紧要。无论差异离显著有多远，这里都没有任何结果说明各组相等。</translation>
    </message>
    <message>
        <source>Whether the groups are equal within the margin</source>
        <translation>各组在界值之内是否等效</translation>
    </message>
    <message>
        <source>two one-sided tests, linear mixed model</source>
        <translation>双单侧检验，线性混合模型</translation>
    </message>
    <message>
        <source>two one-sided tests, analysis of covariance</source>
        <translation>双单侧检验，协方差分析</translation>
    </message>
    <message>
        <source>Difference [90 %, not adjusted]</source>
        <translation>差异 [90 %，未校正]</translation>
    </message>
    <message>
        <source>p (of equality)</source>
        <translation>p（等效）</translation>
    </message>
    <message>
        <source>Equal within %1 points (5 %)</source>
        <translation>在 %1 分之内等效（5 %）</translation>
    </message>
    <message>
        <source>Planned with the cohort: a difference of at most %1 points does not matter. Equal: the 90 % interval lies within -%1 to %1, which is where p is below 0.05. Not shown to be equal does not say that the groups differ.</source>
        <translation>随队列计划规定：不超过 %1 分的差异无关紧要。等效：90 % 区间落在 -%1 到 %1 之内，即 p 小于 0.05。未显示等效并不说明各组不同。</translation>
    </message>
    <message>
        <source>not shown</source>
        <translation>未显示</translation>
    </message>
    <message>
        <source>Agreement of the raters in whole points, pair by pair</source>
        <translation>评分者按整分两两比较的一致性</translation>
    </message>
    <message>
        <source>Cohen&apos;s kappa with quadratic weights; marks rounded to whole points</source>
        <translation>二次加权的 Cohen κ；评分取整到整分</translation>
    </message>
    <message>
        <source>Pairs of raters</source>
        <translation>评分者对数</translation>
    </message>
    <message>
        <source>Marks compared</source>
        <translation>比较的评分数</translation>
    </message>
    <message>
        <source>Kappa, median (lowest to highest)</source>
        <translation>κ，中位数（最低至最高）</translation>
    </message>
    <message>
        <source>Same point</source>
        <translation>同一整分</translation>
    </message>
    <message>
        <source>Within one point</source>
        <translation>相差不超过一分</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1（%2 至 %3）</translation>
    </message>
    <message>
        <source>Kappa is agreement beyond what the raters&apos; own habits would give; a distance counts by its square. One pair far below the others names raters who should talk: see their severity.</source>
        <translation>κ 表示超出评分者各自习惯所能给出的一致性；差距按平方计。某一对远低于其他对时，这两位评分者应当沟通：参见其严格度。</translation>
    </message>
    <message>
        <source>trajectories cannot be written at this rate</source>
        <translation>无法按此频率写出轨迹</translation>
    </message>
    <message>
        <source>Take a rate that divides 1000 Hz, for example 100</source>
        <translation>请选择能整除 1000 Hz 的频率，例如 100</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>The head of each recording: what was trained, with what, and where its trajectory lies.</source>
        <translation>每次录制的概要：练习内容、所用设备，以及轨迹文件的位置。</translation>
    </message>
    <message>
        <source>organ</source>
        <translation>器官</translation>
    </message>
    <message>
        <source>pattern of twist</source>
        <translation>扭转方式</translation>
    </message>
    <message>
        <source>target angle</source>
        <translation>目标角度</translation>
    </message>
    <message>
        <source>BLAKE2b-256 of the organ&apos;s file</source>
        <translation>器官文件的 BLAKE2b-256 值</translation>
    </message>
    <message>
        <source>file of the tissue model&apos;s parameters</source>
        <translation>组织模型参数文件</translation>
    </message>
    <message>
        <source>input device</source>
        <translation>输入设备</translation>
    </message>
    <message>
        <source>largest force of the device</source>
        <translation>设备最大力</translation>
    </message>
    <message>
        <source>program that recorded</source>
        <translation>录制所用程序</translation>
    </message>
    <message>
        <source>lines of the trajectory a second</source>
        <translation>轨迹每秒行数</translation>
    </message>
    <message>
        <source>lines of the trajectory</source>
        <translation>轨迹行数</translation>
    </message>
    <message>
        <source>file of the trajectory</source>
        <translation>轨迹文件</translation>
    </message>
    <message>
        <source>there is no such form of a data set</source>
        <translation>没有这种数据集格式</translation>
    </message>
    <message>
        <source>the data set has no title</source>
        <translation>数据集缺少标题</translation>
    </message>
    <message>
        <source>Give it a title</source>
        <translation>请填写标题</translation>
    </message>
    <message>
        <source>the licence is missing or is no SPDX identifier</source>
        <translation>未填写许可协议，或不是 SPDX 标识</translation>
    </message>
    <message>
        <source>Name the licence, for example CC-BY-4.0</source>
        <translation>请填写许可协议，例如 CC-BY-4.0</translation>
    </message>
    <message>
        <source>the folder of the data set is not empty</source>
        <translation>数据集文件夹不为空</translation>
    </message>
    <message>
        <source>Choose a new folder, so that nothing is mixed</source>
        <translation>请选择新的文件夹，以免内容混杂</translation>
    </message>
    <message>
        <source>time since the recording began</source>
        <translation>录制开始后的时间</translation>
    </message>
    <message>
        <source>tip of the instrument, x</source>
        <translation>器械尖端位置 x</translation>
    </message>
    <message>
        <source>tip of the instrument, y</source>
        <translation>器械尖端位置 y</translation>
    </message>
    <message>
        <source>tip of the instrument, z</source>
        <translation>器械尖端位置 z</translation>
    </message>
    <message>
        <source>rotation of the instrument, quaternion, real part</source>
        <translation>器械姿态四元数，实部</translation>
    </message>
    <message>
        <source>rotation of the instrument, quaternion, x</source>
        <translation>器械姿态四元数 x</translation>
    </message>
    <message>
        <source>rotation of the instrument, quaternion, y</source>
        <translation>器械姿态四元数 y</translation>
    </message>
    <message>
        <source>rotation of the instrument, quaternion, z</source>
        <translation>器械姿态四元数 z</translation>
    </message>
    <message>
        <source>turn about the stylus, unwrapped</source>
        <translation>绕笔杆轴的转角（连续值）</translation>
    </message>
    <message>
        <source>closure of the jaw, 0 open to 1 closed</source>
        <translation>钳口闭合程度，0 为张开，1 为闭合</translation>
    </message>
    <message>
        <source>twist of the held section</source>
        <translation>夹持截面的扭转角</translation>
    </message>
    <message>
        <source>torque that holds the twist</source>
        <translation>维持扭转的扭矩</translation>
    </message>
    <message>
        <source>force of the tissue, x</source>
        <translation>组织作用力 x</translation>
    </message>
    <message>
        <source>force of the tissue, y</source>
        <translation>组织作用力 y</translation>
    </message>
    <message>
        <source>force of the tissue, z</source>
        <translation>组织作用力 z</translation>
    </message>
    <message>
        <source>force that the device was told to give, x</source>
        <translation>发送给设备的力 x</translation>
    </message>
    <message>
        <source>force that the device was told to give, y</source>
        <translation>发送给设备的力 y</translation>
    </message>
    <message>
        <source>force that the device was told to give, z</source>
        <translation>发送给设备的力 z</translation>
    </message>
    <message>
        <source>stage of the exercise</source>
        <translation>练习阶段</translation>
    </message>
    <message>
        <source>moves freely</source>
        <translation>自由移动</translation>
    </message>
    <message>
        <source>touches</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>holds and twists</source>
        <translation>夹持并扭转</translation>
    </message>
    <message>
        <source>has let go</source>
        <translation>已松开</translation>
    </message>
    <message>
        <source>what touches, sum of: 1 jaw, 2 shaft, 4 tissue is held</source>
        <translation>接触部位，以下各项之和：1 钳口，2 器械杆，4 已夹持组织</translation>
    </message>
    <message>
        <source>state of the device, 0 is sound</source>
        <translation>设备状态，0 为正常</translation>
    </message>
    <message>
        <source>Take frictionless, ro-crate or bids</source>
        <translation>请选择 frictionless、ro-crate 或 bids</translation>
    </message>
    <message>
        <source>The database does not answer</source>
        <translation>数据库没有响应</translation>
    </message>
    <message>
        <source>no target has a score by every rater</source>
        <translation>没有任何对象获得所有评分者的评分</translation>
    </message>
    <message>
        <source>Attempts within which both hold</source>
        <translation>两种错误率所对应的尝试次数</translation>
    </message>
    <message>
        <source>Answer, adjusted for the score before, with the 95 % interval of each pair by itself: %1.</source>
        <translation>答案（已按训练前得分校正，区间为每一配对各自的 95 % 区间）：%1。</translation>
    </message>
    <message>
        <source>Answer: no difference between two groups was shown. The largest, adjusted for the score before, with the 95 % interval of this pair by itself: %1, %2. %3</source>
        <translation>答案：未显示任何两组之间有差异。最大的差异（已按训练前得分校正，区间为该配对自身的 95 % 区间）：%1，%2。%3</translation>
    </message>
    <message>
        <source>%1 of %2 marks are missing, so the answer is that of the linear mixed model, which takes every mark that was given; the planned analysis stands beside it.</source>
        <translation>%2 个评分中缺失 %1 个，因此答案取自线性混合模型，它使用给出的每一个评分；计划的分析并列给出。</translation>
    </message>
    <message>
        <source>The missing marks could, at worst, leave open which group is better in %1 of %2 {comparison|comparisons}.</source>
        <translation>在最坏情况下，缺失的评分会使 %2 项比较中的 %1 项无法判定哪一组更好。</translation>
    </message>
    <message>
        <source>The difference depends on the score before (test of equal slopes: %1): read the table with a slope for each group.</source>
        <translation>差异随训练前得分而变（斜率相等检验：%1）：请看各组斜率分开的表。</translation>
    </message>
    <message>
        <source>Intervals are not adjusted for the number of pairs.</source>
        <translation>区间未按配对数校正。</translation>
    </message>
    <message>
        <source>there is no simulated trainee here</source>
        <translation>这里没有模拟学员</translation>
    </message>
    <message>
        <source>people</source>
        <translation>人员</translation>
    </message>
    <message>
        <source>Set up a centre with a demonstration cohort, or look round before the first set-up</source>
        <translation>请在设置中心时加入演示队列，或在首次设置之前先随意看看</translation>
    </message>
    <message>
        <source>this case has no such remark</source>
        <translation>该案例没有这条评语</translation>
    </message>
    <message>
        <source>Open the case again</source>
        <translation>请重新打开该案例</translation>
    </message>
    <message>
        <source>this question has no answer yet</source>
        <translation>该提问尚无答复</translation>
    </message>
    <message>
        <source>Answer it first</source>
        <translation>请先答复</translation>
    </message>
    <message>
        <source>there is no such version of the remark</source>
        <translation>评语没有这个版本</translation>
    </message>
    <message>
        <source>somebody else wrote this remark</source>
        <translation>这条评语是别人写的</translation>
    </message>
    <message>
        <source>Edit one of your own</source>
        <translation>请修改您自己的评语</translation>
    </message>
    <message>
        <source>this remark has no words</source>
        <translation>这条评语没有文字</translation>
    </message>
    <message>
        <source>Write a new one</source>
        <translation>请另写一条</translation>
    </message>
    <message>
        <source>the new words are missing</source>
        <translation>缺少新的文字</translation>
    </message>
    <message>
        <source>Write what you want to say; a remark is not taken away</source>
        <translation>请写下要说的内容；评语不能撤销</translation>
    </message>
    <message>
        <source>the words are the same</source>
        <translation>文字没有变化</translation>
    </message>
    <message>
        <source>Change them, or leave the remark as it is</source>
        <translation>请修改文字，或保持原样</translation>
    </message>
    <message>
        <source>this version of the remark</source>
        <translation>评语的这个版本</translation>
    </message>
    <message>
        <source>%1, held at zero</source>
        <translation>%1，固定为零</translation>
    </message>
    <message>
        <source>A curve was fitted to %1 of %2 {trainee|trainees}. An error that falls like a straight line, or not at all, does not level off and has none.</source>
        <translation>%2 名学员中有 %1 名拟合出曲线。误差像直线一样下降或根本不下降时不会趋于平稳，因而没有曲线。</translation>
    </message>
    <message>
        <source>Groups are compared by an analysis of covariance: the score at the end, adjusted for the score before, one pooled slope; the trainee is the unit.</source>
        <translation>各组用协方差分析比较：结束得分按训练前得分校正，各组共用一个斜率；以学员为分析单位。</translation>
    </message>
    <message>
        <source>Effect sizes are Hedges g with intervals from the noncentral t distribution. Agreement of raters is the intraclass correlation for absolute agreement (Shrout and Fleiss) and Krippendorff&apos;s alpha. Severity is a rater&apos;s mean distance from the other raters.</source>
        <translation>效应量为 Hedges g，区间取自非中心 t 分布。评分者一致性为绝对一致的组内相关系数（Shrout 与 Fleiss）和 Krippendorff α。严格度为某评分者与其他评分者的平均差距。</translation>
    </message>
    <message>
        <source>Raters with marks at the other end of the study but none %1: %2. The scores before and at the end are then not means over the same raters, which shifts the gains of all groups alike and not the differences between them.</source>
        <translation>在研究的另一端给过评分、但在“%1”未给评分的评分者：%2。因此训练前与结束时的得分不是同一批评分者的平均，这会使各组的增益同样偏移，而不影响组间差异。</translation>
    </message>
    <message>
        <source>Planned and used: the analysis of covariance of the score at the end on the score before. Every trainee has the marks that most have at the first and the last occasion.</source>
        <translation>计划并采用：以训练前得分为协变量的结束得分协方差分析。每名学员在首末两个评分时点都有多数学员所有的评分。</translation>
    </message>
    <message>
        <source>the values do not level off within these attempts</source>
        <translation>数值在这些尝试之内没有趋于平稳</translation>
    </message>
    <message>
        <source>the centre does not let anybody in by a code</source>
        <translation>中心不允许凭代码登录</translation>
    </message>
    <message>
        <source>cards for the kiosk</source>
        <translation>自助终端卡片</translation>
    </message>
    <message>
        <source>Switch it on under Devices, At every station</source>
        <translation>请在“设备”页的“所有工作站”中开启</translation>
    </message>
    <message>
        <source>nobody is chosen</source>
        <translation>未选择任何人</translation>
    </message>
    <message>
        <source>a card opens a kiosk for trainees only</source>
        <translation>卡片仅供学员在自助终端登录</translation>
    </message>
    <message>
        <source>Choose users whose only role is that of a trainee</source>
        <translation>请选择仅有学员角色的用户</translation>
    </message>
    <message>
        <source>a code is taken back with a reason only</source>
        <translation>撤销代码必须说明理由</translation>
    </message>
    <message>
        <source>you are nobody of the record</source>
        <translation>您不在记录的人员之中</translation>
    </message>
    <message>
        <source>Sign in as a trainee</source>
        <translation>请以学员身份登录</translation>
    </message>
    <message>
        <source>you have asked for this already</source>
        <translation>您已经提出过这项申请</translation>
    </message>
    <message>
        <source>Wait for the answer, or take it back</source>
        <translation>请等待答复，或收回申请</translation>
    </message>
    <message>
        <source>this is no request of yours</source>
        <translation>这不是您的申请</translation>
    </message>
    <message>
        <source>Read the page again</source>
        <translation>请重新打开该页</translation>
    </message>
    <message>
        <source>a request is declined with a reason only</source>
        <translation>拒绝申请必须说明理由</translation>
    </message>
    <message>
        <source>Report %1  |  numbers %2</source>
        <translation>报告 %1  |  数值 %2</translation>
    </message>
    <message>
        <source>program file that computes it (BLAKE2b)</source>
        <translation>计算它的程序文件 (BLAKE2b)</translation>
    </message>
    <message>
        <source>not shown to you one by one; so many</source>
        <translation>不逐项向您显示，共</translation>
    </message>
    <message>
        <source>content hash</source>
        <translation>内容哈希</translation>
    </message>
    <message>
        <source>recorded by program version</source>
        <translation>记录时的程序版本</translation>
    </message>
    <message>
        <source>started</source>
        <translation>开始时间</translation>
    </message>
    <message>
        <source>parameters of the model</source>
        <translation>模型参数</translation>
    </message>
    <message>
        <source>version</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>submitted</source>
        <translation>提交时间</translation>
    </message>
    <message>
        <source>seen live</source>
        <translation>现场观看</translation>
    </message>
    <message>
        <source>called</source>
        <translation>呼叫时间</translation>
    </message>
    <message>
        <source>case</source>
        <translation>案例</translation>
    </message>
    <message>
        <source>scoring sheet</source>
        <translation>评分标准</translation>
    </message>
    <message>
        <source>criterion %1</source>
        <translation>评分项 %1</translation>
    </message>
    <message>
        <source>anchor %1</source>
        <translation>锚点 %1</translation>
    </message>
    <message>
        <source>plan of the day</source>
        <translation>当日计划</translation>
    </message>
    <message>
        <source>a slot needs a place</source>
        <translation>时段需要地点</translation>
    </message>
    <message>
        <source>Name at least one station or room</source>
        <translation>请至少写出一个工作站或房间</translation>
    </message>
    <message>
        <source>a place comes twice</source>
        <translation>同一地点出现两次</translation>
    </message>
    <message>
        <source>Name each station or room once</source>
        <translation>每个工作站或房间只写一次</translation>
    </message>
    <message>
        <source>a slot takes no time</source>
        <translation>时段没有时长</translation>
    </message>
    <message>
        <source>Give minutes above zero</source>
        <translation>请输入大于零的分钟数</translation>
    </message>
    <message>
        <source>%1 is taken at that time, by %2</source>
        <translation>%1 在该时间已由 %2 占用</translation>
    </message>
    <message>
        <source>Choose another time or place, or take that slot out of the plan</source>
        <translation>请选择其他时间或地点，或从计划中删除该时段</translation>
    </message>
    <message>
        <source>has another slot at that time, at %1</source>
        <translation>在该时间已有另一时段，地点 %1</translation>
    </message>
    <message>
        <source>Choose another time, or take that slot out of the plan</source>
        <translation>请选择其他时间，或从计划中删除该时段</translation>
    </message>
    <message>
        <source>this trainee takes no part in the cohort</source>
        <translation>该学员不参加此批次</translation>
    </message>
    <message>
        <source>this slot is in the plan no more</source>
        <translation>该时段已不在计划中</translation>
    </message>
    <message>
        <source>Read the plan again</source>
        <translation>请重新读取计划</translation>
    </message>
    <message>
        <source>Signed in with the code of a card</source>
        <translation>凭卡片代码登录</translation>
    </message>
    <message>
        <source>Code of a card made</source>
        <translation>已生成卡片代码</translation>
    </message>
    <message>
        <source>Code of a card revoked</source>
        <translation>已撤销卡片代码</translation>
    </message>
    <message>
        <source>Asked about their own record</source>
        <translation>就本人记录提出申请</translation>
    </message>
    <message>
        <source>Request about the own record answered</source>
        <translation>已答复关于本人记录的申请</translation>
    </message>
    <message>
        <source>Slot of a day planned</source>
        <translation>已安排时段</translation>
    </message>
    <message>
        <source>Slot of a day taken out of the plan</source>
        <translation>已从计划中删除时段</translation>
    </message>
    <message>
        <source>request about the own record</source>
        <translation>关于本人记录的申请</translation>
    </message>
    <message>
        <source>a copy of everything kept</source>
        <translation>所保存全部内容的副本</translation>
    </message>
    <message>
        <source>erasing the record</source>
        <translation>删除记录</translation>
    </message>
    <message>
        <source>done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>declined</source>
        <translation>已拒绝</translation>
    </message>
    <message>
        <source>taken back</source>
        <translation>已收回</translation>
    </message>
    <message>
        <source>%1, see the section Competence</source>
        <translation>%1，见“胜任”一节</translation>
    </message>
    <message>
        <source>a mark of a criterion belongs to no group, occasion or scoring sheet</source>
        <translation>某评分项的评分不属于任何组、评分时点或评分标准</translation>
    </message>
    <message>
        <source>%1, revision %2</source>
        <translation>%1，修订版 %2</translation>
    </message>
    <message>
        <source>Scoring sheet as the raters saw it: %1</source>
        <translation>评分者所见的评分标准：%1</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>评分项</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>量程</translation>
    </message>
    <message>
        <source>What the marks mean (anchors)</source>
        <translation>各评分的含义（锚点）</translation>
    </message>
    <message>
        <source>Criteria by group: %1</source>
        <translation>各组的评分项：%1</translation>
    </message>
    <message>
        <source>mean over trainees of the mean of their raters</source>
        <translation>各学员评分者均值的均值</translation>
    </message>
    <message>
        <source>Criteria by trainee: %1</source>
        <translation>各学员的评分项：%1</translation>
    </message>
    <message>
        <source>mean over the raters</source>
        <translation>评分者的均值</translation>
    </message>
    <message>
        <source>What each rater gave for each criterion stands in the table of numbers (CSV), section &quot;criterion&quot;.</source>
        <translation>每位评分者对每个评分项的评分见数值表 (CSV) 的 “criterion” 部分。</translation>
    </message>
    <message>
        <source>Means of fewer than %1 marks are left out: a single mark could be read from them.</source>
        <translation>少于 %1 个评分的均值不予列出：否则可从中读出单个评分。</translation>
    </message>
    <message>
        <source>Criteria of the scoring sheet</source>
        <translation>评分标准的评分项</translation>
    </message>
    <message>
        <source>Raters gave a mark for each criterion and an overall mark. Scores, comparison and agreement are those of the overall mark; the criteria show what it rests on and enter no test.</source>
        <translation>评分者对每个评分项和总体各给出一个评分。得分、比较和一致性均依据总体评分；评分项说明其依据，不进入任何检验。</translation>
    </message>
    <message>
        <source>Scoring sheet</source>
        <translation>评分标准</translation>
    </message>
    <message>
        <source>this request was answered already</source>
        <translation>该申请已经答复</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 (edited)</source>
        <translation>%1（已修改）</translation>
    </message>
    <message>
        <source>%1 is signed in here. Nothing was lost; the work goes on where it was left.</source>
        <translation>%1 已在此登录。内容没有丢失，解锁后可继续。</translation>
    </message>
    <message>
        <source>%1 long</source>
        <translation>时长 %1</translation>
    </message>
    <message>
        <source>%1 long; greatest angle %2 degrees, torque %3 newton metres, force %4 newtons; bookmarks: %5</source>
        <translation>时长 %1；最大角度 %2 度，扭矩 %3 牛·米，力 %4 牛；书签：%5</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分钟</translation>
    </message>
    <message>
        <source>%1 of %2 submitted</source>
        <translation>已提交 %1 个，共 %2 个</translation>
    </message>
    <message>
        <source>%1 overdue</source>
        <translation>%1 份已逾期</translation>
    </message>
    <message>
        <source>%1 {case fits|cases fit} into ten minutes</source>
        <translation>十分钟内可完成 %1 个案例</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>%1 ×, locked</source>
        <translation>%1 ×，已锁定</translation>
    </message>
    <message>
        <source>%1: half a point less</source>
        <translation>%1：减半分</translation>
    </message>
    <message>
        <source>%1: half a point more</source>
        <translation>%1：加半分</translation>
    </message>
    <message>
        <source>%1: not assessable</source>
        <translation>%1：无法评判</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>5 s back</source>
        <translation>后退 5 秒</translation>
    </message>
    <message>
        <source>5 s on</source>
        <translation>前进 5 秒</translation>
    </message>
    <message>
        <source>A training tool and not a medical device. No patient data.</source>
        <translation>培训工具，不是医疗器械。不含患者数据。</translation>
    </message>
    <message>
        <source>After each figure the next row is marked by itself</source>
        <translation>每次打分后自动选中下一行</translation>
    </message>
    <message>
        <source>All done</source>
        <translation>全部完成</translation>
    </message>
    <message>
        <source>All rows have the same mark. Is that meant?</source>
        <translation>各项评分完全相同，是否有意如此？</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Another row</source>
        <translation>其他项</translation>
    </message>
    <message>
        <source>Asked for: %1</source>
        <translation>任务要求：%1</translation>
    </message>
    <message>
        <source>at least %1 {twist|twists}</source>
        <translation>至少 %1 次扭转</translation>
    </message>
    <message>
        <source>At least fifteen characters, a short sentence for example. Nothing else is asked for.</source>
        <translation>至少十五个字符，例如一个短句，没有其他要求。</translation>
    </message>
    <message>
        <source>Auto-advance</source>
        <translation>自动前进</translation>
    </message>
    <message>
        <source>Back to the sheet</source>
        <translation>返回评分表</translation>
    </message>
    <message>
        <source>Back to the sign-in</source>
        <translation>返回登录</translation>
    </message>
    <message>
        <source>Beginning, end of the recording</source>
        <translation>记录的开头、结尾</translation>
    </message>
    <message>
        <source>begun and saved with every key</source>
        <translation>已开始，每次按键均已保存</translation>
    </message>
    <message>
        <source>Bookmark</source>
        <translation>书签</translation>
    </message>
    <message>
        <source>Bookmark this moment, for yourself</source>
        <translation>为自己标记此刻</translation>
    </message>
    <message>
        <source>Bookmarks and remarks</source>
        <translation>书签与评语</translation>
    </message>
    <message>
        <source>Bookmarks are yours; remarks reach the trainee when the marks are released.</source>
        <translation>书签仅供您自己使用；评语在评分公布后送达学员。</translation>
    </message>
    <message>
        <source>Bookmarks this moment for yourself (B)</source>
        <translation>为自己添加书签（B）</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>案例</translation>
    </message>
    <message>
        <source>Case %1</source>
        <translation>案例 %1</translation>
    </message>
    <message>
        <source>Case %1 is submitted and sealed</source>
        <translation>案例 %1 已提交并封存</translation>
    </message>
    <message>
        <source>Cases are blinded and shuffled for you alone. Nobody sees your marks before all have submitted, and you see nobody&apos;s.</source>
        <translation>案例已盲化，并为您单独打乱顺序。在所有人提交之前，没有人能看到您的评分，您也看不到他人的评分。</translation>
    </message>
    <message>
        <source>Change what must be changed, give the reason, seal the new version. Both versions are kept.</source>
        <translation>修改必要之处，写明理由，封存新版本。两个版本均保留。</translation>
    </message>
    <message>
        <source>Checks the sheet and asks once more (Ctrl+Enter)</source>
        <translation>检查评分表并再次确认（Ctrl+Enter）</translation>
    </message>
    <message>
        <source>Choose a new password</source>
        <translation>设置新密码</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清空</translation>
    </message>
    <message>
        <source>clearing of %1</source>
        <translation>清除 %1</translation>
    </message>
    <message>
        <source>clearing of the sheet</source>
        <translation>清空评分表</translation>
    </message>
    <message>
        <source>comment</source>
        <translation>评论</translation>
    </message>
    <message>
        <source>Comment for the trainee</source>
        <translation>给学员的评论</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Continue the draft</source>
        <translation>继续草稿</translation>
    </message>
    <message>
        <source>Draft found and opened</source>
        <translation>已找到并打开草稿</translation>
    </message>
    <message>
        <source>Drafts</source>
        <translation>草稿</translation>
    </message>
    <message>
        <source>due %1</source>
        <translation>截止 %1</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>修改</translation>
    </message>
    <message>
        <source>Edit the nearest remark of yours</source>
        <translation>修改您最近位置的评语</translation>
    </message>
    <message>
        <source>Edit the remark at %1</source>
        <translation>修改 %1 处的评语</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适合画面</translation>
    </message>
    <message>
        <source>Five seconds back, pause, play</source>
        <translation>后退五秒、暂停、播放</translation>
    </message>
    <message>
        <source>force up to %1 N</source>
        <translation>力不超过 %1 N</translation>
    </message>
    <message>
        <source>from the length of the recordings</source>
        <translation>按录制时长估计</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>Give the selected row a mark; 1 and then 0 is ten</source>
        <translation>为选中的一项评分；先按 1 再按 0 为十分</translation>
    </message>
    <message>
        <source>Give your sign-in name and your password.</source>
        <translation>请输入登录名和密码。</translation>
    </message>
    <message>
        <source>Go to %1</source>
        <translation>转到 %1</translation>
    </message>
    <message>
        <source>Half a point less or more; with Shift the finest step</source>
        <translation>减或加半分；按住 Shift 为最小步长</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>此处</translation>
    </message>
    <message>
        <source>hold for %1 s</source>
        <translation>保持 %1 秒</translation>
    </message>
    <message>
        <source>It was open in another window or at the desk, and something newer is stored there. Which one shall stand?</source>
        <translation>该评分表曾在另一窗口或工作站上打开，并已存有更新的内容。以哪一份为准？</translation>
    </message>
    <message>
        <source>It was played at a speed that is not allowed.</source>
        <translation>播放速度超出允许范围。</translation>
    </message>
    <message>
        <source>J slower, L faster; the speed is kept with the mark</source>
        <translation>J 减速，L 加速；速度随评分一并保存</translation>
    </message>
    <message>
        <source>Jumps five seconds back (J)</source>
        <translation>后退五秒（J）</translation>
    </message>
    <message>
        <source>Jumps five seconds on; what is skipped does not count as watched</source>
        <translation>前进五秒；跳过的部分不计入已观看</translation>
    </message>
    <message>
        <source>Keep mine on top</source>
        <translation>以我的为准</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>mark of %1</source>
        <translation>%1 的评分</translation>
    </message>
    <message>
        <source>New password</source>
        <translation>新密码</translation>
    </message>
    <message>
        <source>Newer</source>
        <translation>较新的</translation>
    </message>
    <message>
        <source>Next deadline</source>
        <translation>最近截止日期</translation>
    </message>
    <message>
        <source>no mark yet</source>
        <translation>尚未评分</translation>
    </message>
    <message>
        <source>No recorded case is assigned to you. New ones appear here by themselves.</source>
        <translation>没有分配给您的录制案例。新案例会自动出现在这里。</translation>
    </message>
    <message>
        <source>Not assessable</source>
        <translation>无法评判</translation>
    </message>
    <message>
        <source>not assessable</source>
        <translation>无法评判</translation>
    </message>
    <message>
        <source>Not assessable: type why, Enter</source>
        <translation>无法评定：输入原因，回车</translation>
    </message>
    <message>
        <source>Not saved yet, trying again</source>
        <translation>尚未保存，正在重试</translation>
    </message>
    <message>
        <source>Not saved yet: sign in again</source>
        <translation>尚未保存：请重新登录</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>未保存：%1</translation>
    </message>
    <message>
        <source>Not saved: the sheet was changed elsewhere</source>
        <translation>未保存：评分表已在别处更改</translation>
    </message>
    <message>
        <source>Not stored: the server does not answer. Try again.</source>
        <translation>未存储：服务器没有应答。请重试。</translation>
    </message>
    <message>
        <source>nothing is half done</source>
        <translation>没有未完成的草稿</translation>
    </message>
    <message>
        <source>nothing is overdue</source>
        <translation>没有逾期</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>没有可重做的操作</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>没有可撤销的操作</translation>
    </message>
    <message>
        <source>One picture back, one picture on</source>
        <translation>后退一帧、前进一帧</translation>
    </message>
    <message>
        <source>Out of the sheet, to the button that submits</source>
        <translation>离开评分表，转到提交按钮</translation>
    </message>
    <message>
        <source>Overall</source>
        <translation>总分</translation>
    </message>
    <message>
        <source>overdue</source>
        <translation>已逾期</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>密码</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Play, pause</source>
        <translation>播放、暂停</translation>
    </message>
    <message>
        <source>Plays or pauses (Space)</source>
        <translation>播放或暂停（空格）</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Proves that this is the recording as it was stored. It tells nothing else, and it is another one for each physician</source>
        <translation>证明此录制与存储时一致。它不透露其他信息，且每位医师各不相同</translation>
    </message>
    <message>
        <source>reason for %1</source>
        <translation>%1 的理由</translation>
    </message>
    <message>
        <source>Recording %1, unchanged</source>
        <translation>录制 %1，未改动</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Redo %1 (Ctrl+Y)</source>
        <translation>重做%1（Ctrl+Y）</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>评语</translation>
    </message>
    <message>
        <source>Remark at this moment</source>
        <translation>此刻的评语</translation>
    </message>
    <message>
        <source>Remark at this moment, for the trainee</source>
        <translation>在此刻给学员写评语</translation>
    </message>
    <message>
        <source>Remark at this moment, for the trainee. Enter stores it, Esc leaves it</source>
        <translation>给学员的此刻评语。回车保存，Esc 放弃</translation>
    </message>
    <message>
        <source>Repeat password</source>
        <translation>重复密码</translation>
    </message>
    <message>
        <source>Save password</source>
        <translation>保存密码</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>Say why the mark is changed.</source>
        <translation>请说明更改评分的原因。</translation>
    </message>
    <message>
        <source>Scored at the arm, not here</source>
        <translation>在实物手臂旁评分，不在此处</translation>
    </message>
    <message>
        <source>Scored recordings play as they happened</source>
        <translation>评分录制按原速播放</translation>
    </message>
    <message>
        <source>Seal the new version</source>
        <translation>封存新版本</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>侧面</translation>
    </message>
    <message>
        <source>Sign</source>
        <translation>签名</translation>
    </message>
    <message>
        <source>Sign in</source>
        <translation>登录</translation>
    </message>
    <message>
        <source>Sign out</source>
        <translation>退出登录</translation>
    </message>
    <message>
        <source>Sign-in name</source>
        <translation>登录名</translation>
    </message>
    <message>
        <source>Something is not saved yet and would be lost. Sign out all the same?</source>
        <translation>有内容尚未保存，退出后将丢失。仍要退出登录吗？</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>空格</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Still open: %1.</source>
        <translation>尚未填写：%1。</translation>
    </message>
    <message>
        <source>Store</source>
        <translation>存储</translation>
    </message>
    <message>
        <source>Submit</source>
        <translation>提交</translation>
    </message>
    <message>
        <source>Submit and seal (Ctrl+Enter)</source>
        <translation>提交并封存（Ctrl+Enter）</translation>
    </message>
    <message>
        <source>Submit; a second time seals</source>
        <translation>提交；再按一次封存</translation>
    </message>
    <message>
        <source>submitted and sealed</source>
        <translation>已提交并封存</translation>
    </message>
    <message>
        <source>Submitting seals the sheet.</source>
        <translation>提交后评分表即封存。</translation>
    </message>
    <message>
        <source>Take the mark back</source>
        <translation>收回评分</translation>
    </message>
    <message>
        <source>Take the newer one</source>
        <translation>采用较新的</translation>
    </message>
    <message>
        <source>Takes every mark, reason and comment away; Undo brings them back</source>
        <translation>清除所有评分、理由和评语；可用“撤销”恢复</translation>
    </message>
    <message>
        <source>The new version is sealed; the one before is kept</source>
        <translation>新版本已封存，原版本保留</translation>
    </message>
    <message>
        <source>The organ in three dimensions. Arrows turn it, plus and minus zoom</source>
        <translation>器官的三维视图。方向键旋转，加号和减号缩放</translation>
    </message>
    <message>
        <source>The organ of this recording is not on this machine; the traces are complete.</source>
        <translation>本机没有此录制的器官模型；曲线是完整的。</translation>
    </message>
    <message>
        <source>The overall mark lies outside the rows. Is that meant?</source>
        <translation>总评超出各项评分范围，是否有意如此？</translation>
    </message>
    <message>
        <source>The panel&apos;s marks are open: you move your mark with a reason, and it is flagged as moved after them. Both versions are kept.</source>
        <translation>评分组的评分已公开：您可说明理由后调整评分，该调整会标记为在公开之后作出。两个版本都会保留。</translation>
    </message>
    <message>
        <source>The recording could not be opened.</source>
        <translation>无法打开录制。</translation>
    </message>
    <message>
        <source>The recording is being opened. You may score meanwhile.</source>
        <translation>正在打开录制，您可以先评分。</translation>
    </message>
    <message>
        <source>The rows lie far apart. Is that meant?</source>
        <translation>各项分数相差很大，确定吗？</translation>
    </message>
    <message>
        <source>The server does not answer. Look at the network, then try again.</source>
        <translation>服务器没有应答。请检查网络后重试。</translation>
    </message>
    <message>
        <source>The server does not answer; nothing is lost. Try again: a sheet is never sealed twice.</source>
        <translation>服务器没有应答；内容没有丢失。请重试：评分表不会被重复封存。</translation>
    </message>
    <message>
        <source>The server is busy. Try again in a moment.</source>
        <translation>服务器繁忙。请稍后重试。</translation>
    </message>
    <message>
        <source>The two are not the same yet</source>
        <translation>两次输入尚不一致</translation>
    </message>
    <message>
        <source>This case is scored live; there is no recording.</source>
        <translation>此案例为现场评分，没有录制。</translation>
    </message>
    <message>
        <source>This page could not be opened</source>
        <translation>无法打开此页面</translation>
    </message>
    <message>
        <source>This sheet was changed elsewhere</source>
        <translation>此评分表已在别处更改</translation>
    </message>
    <message>
        <source>Time in the recording</source>
        <translation>录制时间</translation>
    </message>
    <message>
        <source>Time needed</source>
        <translation>所需时间</translation>
    </message>
    <message>
        <source>To the content</source>
        <translation>跳到内容</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上方</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>扭矩</translation>
    </message>
    <message>
        <source>torque up to %1 N m</source>
        <translation>扭矩不超过 %1 N m</translation>
    </message>
    <message>
        <source>Twist to %1° and let go within ±%2°</source>
        <translation>扭转至 %1°，在 ±%2° 内松开</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Undo %1 (Ctrl+Z)</source>
        <translation>撤销%1（Ctrl+Z）</translation>
    </message>
    <message>
        <source>Undo the twist, then hands off</source>
        <translation>解除扭转，然后松手</translation>
    </message>
    <message>
        <source>Undo, redo</source>
        <translation>撤销、重做</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>解锁</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>第 %1 版</translation>
    </message>
    <message>
        <source>Version %1, %2</source>
        <translation>第 %1 版，%2</translation>
    </message>
    <message>
        <source>Version %1, %2, moved after the panel&apos;s marks were open: %3</source>
        <translation>第 %1 版，%2，在评分组评分公开后调整：%3</translation>
    </message>
    <message>
        <source>Version %1, %2: %3</source>
        <translation>第 %1 版，%2：%3</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>待评</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>待评</translation>
    </message>
    <message>
        <source>Watched %1 so far; at least %2 is asked.</source>
        <translation>已观看 %1，至少需要 %2。</translation>
    </message>
    <message>
        <source>Watched %1.</source>
        <translation>已观看 %1。</translation>
    </message>
    <message>
        <source>What would help most next time?</source>
        <translation>下次怎样做最有帮助？</translation>
    </message>
    <message>
        <source>Why %1 cannot be judged</source>
        <translation>%1 为什么无法评判</translation>
    </message>
    <message>
        <source>Why can this not be judged? Enter ends, Esc takes it back</source>
        <translation>为什么无法评判？回车结束，Esc 撤回</translation>
    </message>
    <message>
        <source>Why is the mark changed?</source>
        <translation>为什么修改评分？</translation>
    </message>
    <message>
        <source>Writes to the trainee at this moment (R)</source>
        <translation>在此刻给学员写评语（R）</translation>
    </message>
    <message>
        <source>You may try again now</source>
        <translation>现在可以重试</translation>
    </message>
    <message>
        <source>You sign this as %1. Your name, the time and this meaning are kept with it for good.</source>
        <translation>您以 %1 的身份签名。您的姓名、签名时间和这一含义将随之永久保存。</translation>
    </message>
    <message>
        <source>Your cases</source>
        <translation>您的案例</translation>
    </message>
    <message>
        <source>Your password</source>
        <translation>您的密码</translation>
    </message>
    <message>
        <source>Your password was set by somebody else. Choose one that only you know: at least fifteen characters, a short sentence for example.</source>
        <translation>当前密码由他人设置。请设置只有您知道的密码：至少十五个字符，例如一个短句。</translation>
    </message>
    <message>
        <source>Your queue</source>
        <translation>您的待评列表</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>“%1”</translation>
    </message>
    <message>
        <source>what was watched is not a stretch of the recording</source>
        <translation>报告的观看范围不是录制中的一段</translation>
    </message>
    <message>
        <source>the page sent something that cannot be used</source>
        <translation>页面发来的内容无法使用</translation>
    </message>
    <message>
        <source>Load the page again</source>
        <translation>请重新载入页面</translation>
    </message>
    <message>
        <source>the server is busy</source>
        <translation>服务器繁忙</translation>
    </message>
    <message>
        <source>Try again in a few seconds</source>
        <translation>请几秒后再试</translation>
    </message>
    <message>
        <source>the organ of this recording is not on this machine</source>
        <translation>本机没有此录制的器官模型</translation>
    </message>
    <message>
        <source>too many tries</source>
        <translation>尝试次数过多</translation>
    </message>
    <message>
        <source>Wait a little, then try again</source>
        <translation>请稍候再试</translation>
    </message>
    <message>
        <source>name or password is wrong</source>
        <translation>用户名或密码错误</translation>
    </message>
    <message>
        <source>Type both again, or ask an administrator for a new start password</source>
        <translation>请重新输入，或请管理员设置新的初始密码</translation>
    </message>
    <message>
        <source>Use Torsio&apos;s window at a station</source>
        <translation>请在工作站上使用 Torsio 窗口</translation>
    </message>
    <message>
        <source>there is nothing at this address</source>
        <translation>此地址没有内容</translation>
    </message>
    <message>
        <source>this was not ordered by a page of Torsio</source>
        <translation>此请求并非来自 Torsio 的页面</translation>
    </message>
    <message>
        <source>the text holds a character that cannot be read</source>
        <translation>文本中含有无法识别的字符</translation>
    </message>
    <message>
        <source>Type it anew instead of pasting it</source>
        <translation>请重新输入，不要粘贴</translation>
    </message>
    <message>
        <source>the text has %1 characters; %2 are the most</source>
        <translation>文本有 %1 个字符，最多允许 %2 个</translation>
    </message>
    <message>
        <source>a data set for another record needs codes, and is no BIDS</source>
        <translation>供另一记录使用的数据集须用编码，且不能是 BIDS</translation>
    </message>
    <message>
        <source>Take frictionless or ro-crate, and not pseudonymised</source>
        <translation>请选 frictionless 或 ro-crate，且不要假名化</translation>
    </message>
    <message>
        <source>single marks may not be seen yet</source>
        <translation>尚不可查看单项评分</translation>
    </message>
    <message>
        <source>Freeze the data when every sheet is in, or export as the owner of the file</source>
        <translation>所有评分表收齐后冻结数据，或以文件所有者身份导出</translation>
    </message>
    <message>
        <source>Writing recording %1 of %2</source>
        <translation>正在写出第 %1 个录制，共 %2 个</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在读取 %1</translation>
    </message>
    <message>
        <source>not every mark may be shown yet</source>
        <translation>尚有评分不可显示</translation>
    </message>
    <message>
        <source>this is no study of a data set of Torsio</source>
        <translation>这不是 Torsio 数据集的研究文件</translation>
    </message>
    <message>
        <source>Export the data set anew, with --whole</source>
        <translation>请用 --whole 重新导出该数据集</translation>
    </message>
    <message>
        <source>the study of the data set is damaged</source>
        <translation>数据集的研究文件已损坏</translation>
    </message>
    <message>
        <source>&apos;%1&apos; means nothing here</source>
        <translation>“%1”在此没有意义</translation>
    </message>
    <message>
        <source>the study knows nobody under the code %1</source>
        <translation>研究文件中没有编码为 %1 的人员</translation>
    </message>
    <message>
        <source>the place is more than 200 m away</source>
        <translation>位置超出 200 m</translation>
    </message>
    <message>
        <source>Look at the unit that the map states</source>
        <translation>请检查映射文件中写明的单位</translation>
    </message>
    <message>
        <source>this is no object of JSON</source>
        <translation>这不是 JSON 对象</translation>
    </message>
    <message>
        <source>Look at the example of a map</source>
        <translation>请参照映射文件示例</translation>
    </message>
    <message>
        <source>the map has a word that means nothing here</source>
        <translation>映射文件中有一个在此没有意义的词</translation>
    </message>
    <message>
        <source>Look at its spelling</source>
        <translation>请检查拼写</translation>
    </message>
    <message>
        <source>the map must say this</source>
        <translation>映射文件必须写明此项</translation>
    </message>
    <message>
        <source>Write it into the map; nothing is guessed</source>
        <translation>请写入映射文件；程序不作猜测</translation>
    </message>
    <message>
        <source>this is no text</source>
        <translation>这不是文本</translation>
    </message>
    <message>
        <source>Put it in quotes</source>
        <translation>请加引号</translation>
    </message>
    <message>
        <source>the map must say this number</source>
        <translation>映射文件必须写明此数值</translation>
    </message>
    <message>
        <source>Write it without quotes</source>
        <translation>请不加引号书写</translation>
    </message>
    <message>
        <source>%1 names of columns belong here</source>
        <translation>此处应有 %1 个列名</translation>
    </message>
    <message>
        <source>Name each of them once</source>
        <translation>每个只写一次</translation>
    </message>
    <message>
        <source>a list belongs here</source>
        <translation>此处应为列表</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is none of: %2</source>
        <translation>“%1”不属于：%2</translation>
    </message>
    <message>
        <source>Name one of them</source>
        <translation>请写其中之一</translation>
    </message>
    <message>
        <source>either the file has times, or the map states the rate</source>
        <translation>或者文件带有时间，或者映射文件写明采样率</translation>
    </message>
    <message>
        <source>Leave one of the two out</source>
        <translation>请去掉两者之一</translation>
    </message>
    <message>
        <source>State the rate: these files have no time</source>
        <translation>请写明采样率：此类文件不含时间</translation>
    </message>
    <message>
        <source>this is no rate</source>
        <translation>这不是采样率</translation>
    </message>
    <message>
        <source>State lines a second, up to 10000</source>
        <translation>请写明每秒行数，最大 10000</translation>
    </message>
    <message>
        <source>these files have no time</source>
        <translation>此类文件不含时间</translation>
    </message>
    <message>
        <source>State rate_Hz instead</source>
        <translation>请改写 rate_Hz</translation>
    </message>
    <message>
        <source>the open and the closed jaw read the same</source>
        <translation>钳口张开与闭合的读数相同</translation>
    </message>
    <message>
        <source>State what the file says of each</source>
        <translation>请分别写明文件中的读数</translation>
    </message>
    <message>
        <source>these files say nothing of the jaw</source>
        <translation>此类文件不含钳口信息</translation>
    </message>
    <message>
        <source>Leave it out</source>
        <translation>请去掉此项</translation>
    </message>
    <message>
        <source>the map knows nobody called &apos;%1&apos;</source>
        <translation>映射文件中没有名为“%1”的人员</translation>
    </message>
    <message>
        <source>Enter them in its lists</source>
        <translation>请写入其列表</translation>
    </message>
    <message>
        <source>Enter it under &quot;groups&quot;</source>
        <translation>请写入“groups”</translation>
    </message>
    <message>
        <source>this name stands twice</source>
        <translation>此名称出现两次</translation>
    </message>
    <message>
        <source>Name each person once</source>
        <translation>每人只写一次</translation>
    </message>
    <message>
        <source>this file stands twice</source>
        <translation>此文件出现两次</translation>
    </message>
    <message>
        <source>Name each recording once</source>
        <translation>每个录制只写一次</translation>
    </message>
    <message>
        <source>this is no time</source>
        <translation>这不是时间</translation>
    </message>
    <message>
        <source>Write 2026-01-05T08:00:00Z (UTC)</source>
        <translation>请写作 2026-01-05T08:00:00Z（UTC）</translation>
    </message>
    <message>
        <source>the map lists no recording</source>
        <translation>映射文件未列出任何录制</translation>
    </message>
    <message>
        <source>List at least one</source>
        <translation>请至少列出一个</translation>
    </message>
    <message>
        <source>a whole number belongs here</source>
        <translation>此处应为整数</translation>
    </message>
    <message>
        <source>Look at the scale of the marks</source>
        <translation>请检查评分的量表</translation>
    </message>
    <message>
        <source>only JIGSAWS has such a file</source>
        <translation>只有 JIGSAWS 有此类文件</translation>
    </message>
    <message>
        <source>Name a table instead</source>
        <translation>请改写表格文件</translation>
    </message>
    <message>
        <source>this recording has a mark and no occasion</source>
        <translation>此录制有评分，却没有评分时点</translation>
    </message>
    <message>
        <source>%1 marked %2 twice at one occasion</source>
        <translation>%1 在同一评分时点对 %2 评分两次</translation>
    </message>
    <message>
        <source>Give each of the recordings an occasion of its own</source>
        <translation>请为每个录制写明各自的评分时点</translation>
    </message>
    <message>
        <source>there is no such layout of recordings</source>
        <translation>没有此种录制格式</translation>
    </message>
    <message>
        <source>Take jigsaws, rosma, perktutor or csv</source>
        <translation>请选 jigsaws、rosma、perktutor 或 csv</translation>
    </message>
    <message>
        <source>the map is no JSON</source>
        <translation>映射文件不是 JSON</translation>
    </message>
    <message>
        <source>Look at its quotes, commas and brackets</source>
        <translation>请检查引号、逗号与括号</translation>
    </message>
    <message>
        <source>the line ends before the score</source>
        <translation>该行在分数之前结束</translation>
    </message>
    <message>
        <source>It needs the recording&apos;s name, a skill and the total</source>
        <translation>须有录制名称、水平与总分</translation>
    </message>
    <message>
        <source>there is no mark of any recording of the map</source>
        <translation>没有映射文件所列录制的评分</translation>
    </message>
    <message>
        <source>Look at the names of the recordings</source>
        <translation>请检查录制名称</translation>
    </message>
    <message>
        <source>the map lists no recording &apos;%1&apos;</source>
        <translation>映射文件未列出录制“%1”</translation>
    </message>
    <message>
        <source>Enter it in the map</source>
        <translation>请写入映射文件</translation>
    </message>
    <message>
        <source>the map lists no rater &apos;%1&apos;</source>
        <translation>映射文件未列出评分者“%1”</translation>
    </message>
    <message>
        <source>Enter them in the map</source>
        <translation>请写入映射文件</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>没有此文件</translation>
    </message>
    <message>
        <source>Look at the names in the map</source>
        <translation>请检查映射文件中的名称</translation>
    </message>
    <message>
        <source>Look at its rights</source>
        <translation>请检查其权限</translation>
    </message>
    <message>
        <source>these numbers are no rotation</source>
        <translation>这些数值不构成旋转</translation>
    </message>
    <message>
        <source>Look at the line, and at the form of rotation that the map names</source>
        <translation>请检查该行，以及映射文件写明的旋转形式</translation>
    </message>
    <message>
        <source>the time does not rise</source>
        <translation>时间没有递增</translation>
    </message>
    <message>
        <source>Put the lines in order, and take out those that stand twice</source>
        <translation>请按时间排序，并去掉重复的行</translation>
    </message>
    <message>
        <source>the recording has fewer than two lines</source>
        <translation>录制不足两行</translation>
    </message>
    <message>
        <source>Look at the instrument and the columns that the map names</source>
        <translation>请检查映射文件写明的器械与列</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number</source>
        <translation>“%1”不是数值</translation>
    </message>
    <message>
        <source>Write numbers with a decimal point; leave out lines without a pose</source>
        <translation>数值请用小数点；没有位姿的行请去掉</translation>
    </message>
    <message>
        <source>JIGSAWS has no instrument &apos;%1&apos;</source>
        <translation>JIGSAWS 没有器械“%1”</translation>
    </message>
    <message>
        <source>Name master left, master right, slave left or slave right</source>
        <translation>请写 master left、master right、slave left 或 slave right</translation>
    </message>
    <message>
        <source>JIGSAWS has rotation matrices</source>
        <translation>JIGSAWS 使用旋转矩阵</translation>
    </message>
    <message>
        <source>Name their form: matrix rows or matrix columns</source>
        <translation>请写明形式：matrix rows 或 matrix columns</translation>
    </message>
    <message>
        <source>the line has %1 numbers, not 76</source>
        <translation>该行有 %1 个数值，而非 76 个</translation>
    </message>
    <message>
        <source>Take the kinematics files of JIGSAWS as they are</source>
        <translation>请直接使用 JIGSAWS 的运动学文件</translation>
    </message>
    <message>
        <source>the line has %1 values and the header %2</source>
        <translation>该行有 %1 个值，表头有 %2 个</translation>
    </message>
    <message>
        <source>Give every line as many values as there are columns</source>
        <translation>每行的值数须与列数相同</translation>
    </message>
    <message>
        <source>there is not one column &apos;%1&apos;</source>
        <translation>没有唯一的列“%1”</translation>
    </message>
    <message>
        <source>Look at the names in the map and in the first line</source>
        <translation>请检查映射文件与首行中的名称</translation>
    </message>
    <message>
        <source>ROSMA has quaternions, x y z w</source>
        <translation>ROSMA 使用四元数，顺序为 x y z w</translation>
    </message>
    <message>
        <source>Name their form: quaternion xyzw, or none</source>
        <translation>请写明形式：quaternion xyzw 或 none</translation>
    </message>
    <message>
        <source>%1 has not one column of %2 %3</source>
        <translation>%1 没有唯一的列 %2 %3</translation>
    </message>
    <message>
        <source>Name an instrument of the file: MTML, MTMR, PSM1 or PSM2</source>
        <translation>请写文件中的器械：MTML、MTMR、PSM1 或 PSM2</translation>
    </message>
    <message>
        <source>Perk Tutor has matrices of 16 numbers</source>
        <translation>Perk Tutor 使用 16 个数值的矩阵</translation>
    </message>
    <message>
        <source>sequences of Slicer are not read</source>
        <translation>不读取 Slicer 的序列文件</translation>
    </message>
    <message>
        <source>Save the transforms as XML in Perk Tutor</source>
        <translation>请在 Perk Tutor 中把变换存为 XML</translation>
    </message>
    <message>
        <source>the transform has %1 numbers, not 16</source>
        <translation>变换有 %1 个数值，而非 16 个</translation>
    </message>
    <message>
        <source>Take the files of Perk Tutor as they are</source>
        <translation>请直接使用 Perk Tutor 的文件</translation>
    </message>
    <message>
        <source>Storing recording %1 of %2</source>
        <translation>正在存入第 %1 个录制，共 %2 个</translation>
    </message>
    <message>
        <source>the record has somebody under this code already</source>
        <translation>记录中已有使用此编码的人员</translation>
    </message>
    <message>
        <source>Import into an empty record</source>
        <translation>请导入到空记录中</translation>
    </message>
    <message>
        <source>the record has no class of raters &apos;%1&apos;</source>
        <translation>记录中没有评分者类别“%1”</translation>
    </message>
    <message>
        <source>Take intern, deputy_chief, chief or another of its classes</source>
        <translation>请选 intern、deputy_chief、chief 或记录中的其他类别</translation>
    </message>
    <message>
        <source>the curriculum has nothing under this code</source>
        <translation>课程中没有此编码</translation>
    </message>
    <message>
        <source>the record has this recording already</source>
        <translation>记录中已有此录制</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>正在写出 %1</translation>
    </message>
    <message>
        <source>fewer than 20 samples a second were recorded</source>
        <translation>每秒录制不足 20 个采样</translation>
    </message>
    <message>
        <source>not applicable: foreign recording</source>
        <translation>不适用：外来录制</translation>
    </message>
    <message>
        <source>Median time (s)</source>
        <translation>时间中位数（s）</translation>
    </message>
    <message>
        <source>Median path of the tip (m)</source>
        <translation>尖端路径中位数（m）</translation>
    </message>
    <message>
        <source>path of the tip (m)</source>
        <translation>尖端路径（m）</translation>
    </message>
    <message>
        <source>Median idle time (s)</source>
        <translation>停顿时间中位数（s）</translation>
    </message>
    <message>
        <source>idle time (s)</source>
        <translation>停顿时间（s）</translation>
    </message>
    <message>
        <source>Recordings of other equipment by group and phase</source>
        <translation>其他设备的录制，按组与阶段</translation>
    </message>
    <message>
        <source>Force, torque and twist do not apply: no organ answered, and nothing can be computed again.</source>
        <translation>力、扭矩与扭转不适用：没有器官作出反应，也无法重新计算。</translation>
    </message>
    <message>
        <source>Learning of every trainee on other equipment</source>
        <translation>各学员在其他设备上的学习</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>量</translation>
    </message>
    <message>
        <source>First</source>
        <translation>首次</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>末次</translation>
    </message>
    <message>
        <source>Left in the end</source>
        <translation>最终水平</translation>
    </message>
    <message>
        <source>Each trainee is fitted alone; eight runs are the fewest for a curve with three parameters.</source>
        <translation>逐个学员拟合；三参数曲线至少需要八次操作。</translation>
    </message>
    <message>
        <source>other equipment made this recording: there is no organ to be shown or computed again</source>
        <translation>此录制来自其他设备：没有可显示或重新计算的器官</translation>
    </message>
    <message>
        <source>Look at its metrics and at its path in a data set</source>
        <translation>请查看其指标，以及数据集中的路径</translation>
    </message>
    <message>
        <source>the wall was torn: that is not undone</source>
        <translation>壁已撕裂：不算复位</translation>
    </message>
    <message>
        <source>record before or after a move</source>
        <translation>迁移前或迁移后的记录</translation>
    </message>
    <message>
        <source>is a link to a file that is not there</source>
        <translation>是一个链接，但其指向的文件不存在</translation>
    </message>
    <message>
        <source>Connect the disk that it lies on, or remove the link</source>
        <translation>请接上它所在的磁盘，或删除该链接</translation>
    </message>
    <message>
        <source>Check the disk, and whether it is full</source>
        <translation>请检查磁盘，并查看磁盘是否已满</translation>
    </message>
    <message>
        <source>A second look beside the primary comparison. Gains are ranked as whole numbers, of the trainees with a score at both occasions. p (Holm) is Dunn&apos;s; p (exact) is of this pair alone.</source>
        <translation>主要比较之外的补充分析。提高值按整数排秩，只含两个评分时点都有得分的学员。p（Holm）为 Dunn 检验；p（精确）只针对该对。</translation>
    </message>
    <message>
        <source>The record has changed since it was frozen as &quot;%1&quot;: what stands here is computed from the record as it is now, not from what was frozen.</source>
        <translation>自冻结为“%1”以来，记录已改变：此处的结果按现在的记录计算，而不是按冻结时的数据。</translation>
    </message>
    <message>
        <source>Not compared, as nobody has a score at both occasions: %1.</source>
        <translation>以下组无人在两个评分时点都有得分，因此未参与比较：%1。</translation>
    </message>
    <message>
        <source>Not every trainee was marked by the same raters at the end, so the answer is that of the linear mixed model, which allows for it; the planned analysis stands beside it.</source>
        <translation>结束时并非每名学员都由相同的评分者评分，因此答案取自考虑了这一点的线性混合模型；计划的分析并列给出。</translation>
    </message>
    <message>
        <source>What this does not show: %1 Marks on a training arm say nothing about patients.</source>
        <translation>本报告不能说明的：%1训练手臂上的分数不能说明患者的情况。</translation>
    </message>
    <message>
        <source>No test of baseline differences is shown. The draw could not be repeated from its seed: a difference need not be due to chance.</source>
        <translation>不显示基线差异的检验。抽取结果无法由种子重现：差异不一定出于偶然。</translation>
    </message>
    <message>
        <source>the record has changed, and the numbers are those of today; see Provenance</source>
        <translation>记录已改变，数值按今天的记录计算；见“数据来源”</translation>
    </message>
    <message>
        <source>Effect of the group: F(%1, %2) = %3, %4. Adjusted means [95 %]: %5.</source>
        <translation>组别效应：F(%1, %2) = %3，%4。校正均值 [95 %]：%5。</translation>
    </message>
    <message>
        <source>A class of weight 0 enters s2 but not M: %1.</source>
        <translation>权重为 0 的类别计入 s2 而不计入 M：%1。</translation>
    </message>
    <message>
        <source>A class of weight 0 enters neither M nor s2: %1. Its marks are among the raters&apos; own scores and in the order of the models.</source>
        <translation>权重为 0 的类别既不计入 M 也不计入 s2：%1。其评分仍列在评分者各自的得分和模型排序之中。</translation>
    </message>
    <message>
        <source>The text under Eq. 26 of the paper speaks of the chief physicians&apos; scores, but its sum runs over all raters; so does it here, and the chief physicians are shown alone where the figure says so.</source>
        <translation>论文式 (26) 下的文字指主任医师的评分，但求和遍及全体评分者；此处也是如此，仅在图中注明处单独显示主任医师。</translation>
    </message>
    <message>
        <source>Groups are not compared: %1.</source>
        <translation>各组未作比较：%1。</translation>
    </message>
    <message>
        <source>Groups are compared by a linear mixed model, as %1: the marks at the end, adjusted for the mean mark before, trainees and raters as random effects, restricted maximum likelihood, degrees of freedom after Satterthwaite. The planned analysis of covariance stands beside it.</source>
        <translation>因%1，各组用线性混合模型比较：结束时的评分，按训练前的平均评分校正，学员和评分者为随机效应，采用限制性最大似然，自由度按 Satterthwaite 计算。计划的协方差分析并列给出。</translation>
    </message>
    <message>
        <source>marks are missing</source>
        <translation>有评分缺失</translation>
    </message>
    <message>
        <source>not every trainee was marked by the same raters at the end</source>
        <translation>结束时并非每名学员都由相同的评分者评分</translation>
    </message>
    <message>
        <source>%1 (n = %2)</source>
        <translation>%1（n = %2）</translation>
    </message>
    <message>
        <source>Raters who scored trainees of some groups only %1: %2. In the analysis of covariance what such a rater is stricter or more lenient by counts as a difference between the groups; the linear mixed model allows for it.</source>
        <translation>在“%1”只给部分组的学员评分的评分者：%2。在协方差分析中，这类评分者偏严或偏松的程度会被算作组间差异；线性混合模型考虑了这一点。</translation>
    </message>
    <message>
        <source>Raters who scored trainees of some groups only %1: %2. What such a rater is stricter or more lenient by counts as a difference between the groups.</source>
        <translation>在“%1”只给部分组的学员评分的评分者：%2。这类评分者偏严或偏松的程度会被算作组间差异。</translation>
    </message>
    <message>
        <source>Planned: the analysis of covariance of the score at the end on the score before. It is not defined (%1): the groups are not compared.</source>
        <translation>计划的分析：以训练前得分为协变量的结束得分协方差分析。该分析无法定义（%1）：各组未作比较。</translation>
    </message>
    <message>
        <source>Not every trainee was marked by the same raters at the end</source>
        <translation>结束时并非每名学员都由相同的评分者评分</translation>
    </message>
    <message>
        <source>Adjusted means [95 %]: %1.</source>
        <translation>校正均值 [95 %]：%1。</translation>
    </message>
    <message>
        <source>Variances: trainees %1, raters %2, residual %3 (points squared). Slope on the score before [95 %]: %4.</source>
        <translation>方差：学员 %1，评分者 %2，残差 %3（分的平方）。对训练前得分的斜率 [95 %]：%4。</translation>
    </message>
    <message>
        <source>Worst for the first group [95 %, not adjusted]</source>
        <translation>对第一组最不利 [95 %，未校正]</translation>
    </message>
    <message>
        <source>Best for the first group [95 %, not adjusted]</source>
        <translation>对第一组最有利 [95 %，未校正]</translation>
    </message>
    <message>
        <source>The groups have %1 trainees: without two groups of two or more no power can be stated.</source>
        <translation>各组人数为 %1：若没有两个至少两人的组，就无法给出检验效能。</translation>
    </message>
    <message>
        <source>a difference that was not shown is no evidence of equality.</source>
        <translation>未显示差异并不证明相同。</translation>
    </message>
    <message>
        <source>two groups of %1 detect a difference of %2 standard deviations with a power of 0.80 (two-sided t test at 5 %) and miss smaller ones more often; a difference that was not shown is no evidence of equality.</source>
        <translation>两个各 %1 人的组以 0.80 的效能可检出 %2 个标准差的差异（5 % 水平的双侧 t 检验），更小的差异更常被漏掉；未显示差异并不证明相同。</translation>
    </message>
    <message>
        <source>%1 {rater is|raters are} the fewest whose mean has a dependability of %2 or more.</source>
        <translation>至少 %1 名评分者的平均分，其可靠性才达到 %2 或以上。</translation>
    </message>
    <message>
        <source>Not even %1 raters would give a dependability of %2.</source>
        <translation>即使 %1 名评分者也达不到 %2 的可靠性。</translation>
    </message>
    <message>
        <source>A negative component counts as 0 in the rows above.</source>
        <translation>负的方差分量在上面各行中按 0 计算。</translation>
    </message>
    <message>
        <source>no mark here</source>
        <translation>此处无评分</translation>
    </message>
    <message>
        <source>%1, random changes of sign, standard error %2</source>
        <translation>%1，随机变号，标准误 %2</translation>
    </message>
    <message>
        <source>A gain within a group shows no effect of its training: repetition alone may give it. Compare the groups. p values and intervals of this table are not adjusted for the number of groups.</source>
        <translation>组内的进步并不表明训练有效：仅靠重复也可能进步。请比较各组。本表的 p 值和区间未按组数校正。</translation>
    </message>
    <message>
        <source>Marks missing, short of the number that most trainees have at that occasion: %1.</source>
        <translation>缺失的评分（少于该评分时点多数学员的评分数）：%1。</translation>
    </message>
    <message>
        <source>What no rater of a class has scored</source>
        <translation>某一类别中无人评分的内容</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>类别</translation>
    </message>
    <message>
        <source>Indices without a mark</source>
        <translation>没有评分的指标</translation>
    </message>
    <message>
        <source>all %1</source>
        <translation>全部 %1 项</translation>
    </message>
    <message>
        <source>Score of each class of raters by itself</source>
        <translation>各类评分者单独的得分</translation>
    </message>
    <message>
        <source>Score of the class</source>
        <translation>该类别的得分</translation>
    </message>
    <message>
        <source>an index has no mark</source>
        <translation>有指标没有评分</translation>
    </message>
    <message>
        <source>The index weights of Eq. 27 on the plain means of one class. No N is formed while a class that has a weight is missing: the weights of the others would have to be made up.</source>
        <translation>按式 (27) 的指标权重对一个类别的简单均值加权。有权重的类别缺失时不计算 N：否则就得编造其他类别的权重。</translation>
    </message>
    <message>
        <source>Eq. 27 on the means of one class</source>
        <translation>对一个类别的均值用式 (27)</translation>
    </message>
    <message>
        <source>fewer than two groups have scores at both occasions</source>
        <translation>两个评分时点都有得分的组不足两个</translation>
    </message>
    <message>
        <source>the scores after do not vary within groups</source>
        <translation>训练后得分在组内没有变异</translation>
    </message>
    <message>
        <source>fewer than two groups have values</source>
        <translation>有数值的组不足两个</translation>
    </message>
    <message>
        <source>nobody has a score at every occasion</source>
        <translation>无人在每个评分时点都有得分</translation>
    </message>
    <message>
        <source>all %1 rows</source>
        <translation>全部 %1 行</translation>
    </message>
    <message>
        <source>%1 of %2 rows</source>
        <translation>%2 行中的 %1 行</translation>
    </message>
    <message>
        <source>Show fewer</source>
        <translation>收起</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>显示全部</translation>
    </message>
    <message>
        <source>this is no mail address</source>
        <translation>这不是邮件地址</translation>
    </message>
    <message>
        <source>Write it like li@example.org</source>
        <translation>请写成 li@example.org 的形式</translation>
    </message>
    <message>
        <source>this is no name of a server</source>
        <translation>这不是服务器名</translation>
    </message>
    <message>
        <source>Write it like mail.example.org</source>
        <translation>请写成 mail.example.org 的形式</translation>
    </message>
    <message>
        <source>the mail server refuses the sign-in: %1</source>
        <translation>邮件服务器拒绝登录：%1</translation>
    </message>
    <message>
        <source>Check the sign-in name and the password</source>
        <translation>请检查登录名和密码</translation>
    </message>
    <message>
        <source>the mail server refuses: %1</source>
        <translation>邮件服务器拒绝：%1</translation>
    </message>
    <message>
        <source>Check its settings</source>
        <translation>请检查其设置</translation>
    </message>
    <message>
        <source>the mail server does not answer: %1</source>
        <translation>邮件服务器没有应答：%1</translation>
    </message>
    <message>
        <source>Check its name, port and encryption, and the network</source>
        <translation>请检查其名称、端口、加密方式和网络</translation>
    </message>
    <message>
        <source>without encryption messages go to a server on this computer only</source>
        <translation>不加密时只能发往本机上的服务器</translation>
    </message>
    <message>
        <source>Choose an encryption</source>
        <translation>请选择加密方式</translation>
    </message>
    <message>
        <source>Message to %1</source>
        <translation>发给 %1 的邮件</translation>
    </message>
    <message>
        <source>retention</source>
        <translation>保存期限</translation>
    </message>
    <message>
        <source>Choose at least one person</source>
        <translation>请至少选择一人</translation>
    </message>
    <message>
        <source>the description of the pages has no title</source>
        <translation>页面说明缺少标题</translation>
    </message>
    <message>
        <source>a correction needs a reason</source>
        <translation>更正必须说明理由</translation>
    </message>
    <message>
        <source>Say what was wrong</source>
        <translation>请说明哪里有误</translation>
    </message>
    <message>
        <source>this deviation is not of the cohort</source>
        <translation>该方案偏离不属于此批次</translation>
    </message>
    <message>
        <source>the other rater is asked about this case already</source>
        <translation>另一位评分者已被邀请评此案例</translation>
    </message>
    <message>
        <source>sheets</source>
        <translation>评分表</translation>
    </message>
    <message>
        <source>none of these sheets can be moved (submitted: %1, asked already: %2)</source>
        <translation>这些评分表均无法转交（已提交：%1，已被邀请：%2）</translation>
    </message>
    <message>
        <source>Choose other sheets or another rater</source>
        <translation>请选择其他评分表或其他评分者</translation>
    </message>
    <message>
        <source>the sheet was not taken back from its rater</source>
        <translation>该评分表未从评分者处收回</translation>
    </message>
    <message>
        <source>ICC: absolute agreement, raters as a random sample; (2,1) for one rater, (2,k) for the mean over all, which is the reported score of who has a mark of each.</source>
        <translation>ICC：组内相关系数，绝对一致，评分者视为随机样本；(2,1) 针对单个评分者，(2,k) 针对全体均值，即每位评分者都给过评分的学员所报告的得分。</translation>
    </message>
    <message>
        <source>ICC: absolute agreement, raters as a random sample; (2,1) for one rater, (2,k) for the mean over all, which is the reported score.</source>
        <translation>ICC：组内相关系数，绝对一致，评分者视为随机样本；(2,1) 针对单个评分者，(2,k) 针对全体均值，即所报告的得分。</translation>
    </message>
    <message>
        <source>Alpha with the interval metric. A group that is much alike gives a low coefficient even when raters agree well: look at the standard error of measurement (SEM).</source>
        <translation>α 采用等距度量。若各学员水平相近，即使评分者一致性好，系数也会偏低：此时请看测量标准误 (SEM)。</translation>
    </message>
    <message>
        <source>Raters gave an overall mark and one for each criterion that they could assess. Scores, comparison and agreement are those of the overall mark; the criteria show what it rests on and enter no test.</source>
        <translation>评分者给出一个总体评分，并对能够评定的每个评分项各给出一个评分。得分、比较和一致性均依据总体评分；评分项说明其依据，不进入任何检验。</translation>
    </message>
    <message>
        <source>A rater who shares a single trainee with others has no interval.</source>
        <translation>与其他评分者只共有一名学员的评分者没有区间。</translation>
    </message>
    <message>
        <source>A score is the mean over the raters.</source>
        <translation>得分为各评分者的平均。</translation>
    </message>
    <message>
        <source>Where a single trainee has a score the mean has no interval.</source>
        <translation>只有一名学员有得分时，均值没有区间。</translation>
    </message>
    <message>
        <source>Name its occasion in the map: first, second</source>
        <translation>请在映射文件中写明评分时点：first、second</translation>
    </message>
    <message>
        <source>The organ was accepted with a warning: %1.</source>
        <translation>该器官是带警告接受的：%1。</translation>
    </message>
    <message>
        <source>warning about the organ</source>
        <translation>关于器官的警告</translation>
    </message>
    <message>
        <source>M05 the importer needs more than %1 MB of memory for this file</source>
        <translation>M05 读取此文件需要超过 %1 MB 内存</translation>
    </message>
    <message>
        <source>Decimate the surface, or export the mesh again</source>
        <translation>请减少面片数量，或重新导出网格</translation>
    </message>
    <message>
        <source>M05 the importer gave no answer to this file</source>
        <translation>M05 读取程序对此文件没有给出结果</translation>
    </message>
    <message>
        <source>Export the mesh again, or in another format</source>
        <translation>请重新导出网格，或改用其他格式</translation>
    </message>
    <message>
        <source>M05 the system gives no memory to read the file</source>
        <translation>M05 系统无法提供读取此文件所需的内存</translation>
    </message>
    <message>
        <source>M05 the program that reads meshes cannot be started: %1</source>
        <translation>M05 无法启动读取网格的程序：%1</translation>
    </message>
    <message>
        <source>Install Torsio again</source>
        <translation>请重新安装 Torsio</translation>
    </message>
    <message>
        <source>M05 the importer did not come to an end with this file within %1 s</source>
        <translation>M05 读取程序在 %1 秒内未能读完此文件</translation>
    </message>
    <message>
        <source>M05 the importer crashed on this file (signal %1)</source>
        <translation>M05 读取程序在此文件上崩溃（信号 %1）</translation>
    </message>
    <message>
        <source>Import the mesh again with torsio organ import</source>
        <translation>请用 torsio organ import 重新导入网格</translation>
    </message>
    <message>
        <source>this is no organ file of Torsio</source>
        <translation>这不是 Torsio 的器官文件</translation>
    </message>
    <message>
        <source>the organ file was written by a later version</source>
        <translation>该器官文件由更新的版本写成</translation>
    </message>
    <message>
        <source>the organ file is cut short</source>
        <translation>器官文件不完整</translation>
    </message>
    <message>
        <source>the organ file was damaged or changed</source>
        <translation>器官文件已损坏或被改动</translation>
    </message>
    <message>
        <source>the organ file has no head that can be read</source>
        <translation>器官文件的文件头无法读取</translation>
    </message>
    <message>
        <source>the wall must be 0.1 to 50 mm thick</source>
        <translation>壁厚必须在 0.1 至 50 mm 之间</translation>
    </message>
    <message>
        <source>Give its thickness in millimetres</source>
        <translation>请以毫米给出壁厚</translation>
    </message>
    <message>
        <source>%1 doubled or flat {face|faces} removed</source>
        <translation>已删除 %1 个重复或无面积的面</translation>
    </message>
    <message>
        <source>%1 {face|faces} turned that faced the wrong way</source>
        <translation>已翻转 %1 个朝向错误的面</translation>
    </message>
    <message>
        <source>the surface was inside out and was turned</source>
        <translation>表面内外颠倒，已翻转</translation>
    </message>
    <message>
        <source>%1 small separate {piece|pieces} left out</source>
        <translation>已略去 %1 个小的分离部分</translation>
    </message>
    <message>
        <source>%1 inner {shell|shells} left out</source>
        <translation>已略去 %1 个内壳</translation>
    </message>
    <message>
        <source>Give the thickness of the wall instead</source>
        <translation>请改为给出壁厚</translation>
    </message>
    <message>
        <source>left out: %1 {texture|textures}, %2 bones, %3 animations</source>
        <translation>已略去：%1 个纹理、%2 个骨骼、%3 个动画</translation>
    </message>
    <message>
        <source>%1 {hole|holes} closed, the largest %2 mm across</source>
        <translation>已封闭 %1 个孔，最大的宽 %2 mm</translation>
    </message>
    <message>
        <source>Look whether the organ ends there, or close it in a mesh editor</source>
        <translation>请确认器官是否在该处终止，或在网格编辑软件中封闭</translation>
    </message>
    <message>
        <source>the organ holds %1 ml; such an organ holds %2 to %3 ml</source>
        <translation>该器官容积为 %1 ml；此类器官为 %2 至 %3 ml</translation>
    </message>
    <message>
        <source>Check the unit of the file, and which organ it is</source>
        <translation>请核对文件的单位，以及它是哪个器官</translation>
    </message>
    <message>
        <source>the whole organ</source>
        <translation>整个器官</translation>
    </message>
    <message>
        <source>Name the ends of the organ, or cut off what is none of it</source>
        <translation>请指定器官的两端，或去掉不属于它的部分</translation>
    </message>
    <message>
        <source>the organ is %1 times as long as wide; a twist needs a length of at least %2</source>
        <translation>器官的长度是宽度的 %1 倍；扭转要求至少 %2 倍</translation>
    </message>
    <message>
        <source>Choose an organ that is longer than wide, or name its ends</source>
        <translation>请选择长大于宽的器官，或指定其两端</translation>
    </message>
    <message>
        <source>the organ branches: %1 of its surface stands off its section</source>
        <translation>器官有分支：其表面的 %1 偏离所属截面</translation>
    </message>
    <message>
        <source>the organ branches: %1 of its surface lies beyond the ends of its axis</source>
        <translation>器官有分支：其表面的 %1 位于轴线两端之外</translation>
    </message>
    <message>
        <source>the organ is flat: its sections are %1 times as broad as thick</source>
        <translation>器官过扁：其截面的宽度是厚度的 %1 倍</translation>
    </message>
    <message>
        <source>Choose an organ with rounder sections</source>
        <translation>请选择截面较圆的器官</translation>
    </message>
    <message>
        <source>sections run into each other in %1 of the organ: it bends more sharply than it is wide</source>
        <translation>器官有 %1 的部位截面相互重叠：其弯曲比自身宽度更急</translation>
    </message>
    <message>
        <source>Name the ends of the organ, or take a part of it that bends less</source>
        <translation>请指定器官的两端，或取其弯曲较缓的一段</translation>
    </message>
    <message>
        <source>the organ is %1 times as wide in one place as in another: all of the twist goes into the narrow part</source>
        <translation>器官最宽处是最窄处的 %1 倍：扭转全部落在狭窄的部分</translation>
    </message>
    <message>
        <source>Take one part of it, or name the ends of that part</source>
        <translation>请取其中一部分，或指定该部分的两端</translation>
    </message>
    <message>
        <source>Repair the surface in a mesh editor</source>
        <translation>请在网格编辑软件中修复表面</translation>
    </message>
    <message>
        <source>twisted by 60 degrees, det F, the local volume ratio, falls to %1</source>
        <translation>扭转 60 度时，det F（局部体积比）降至 %1</translation>
    </message>
    <message>
        <source>twisted by 60 degrees, the surface crosses itself in %1 {pair|pairs} of triangles</source>
        <translation>扭转 60 度时，表面有 %1 对三角形相互穿插</translation>
    </message>
    <message>
        <source>the pattern &apos;%1&apos; needs an anatomy that this organ is not known to have</source>
        <translation>扭转方式“%1”所需的解剖结构，此器官未说明具备</translation>
    </message>
    <message>
        <source>this was done on a mesh of the user&apos;s, which is not given</source>
        <translation>此记录是在用户自己的网格上进行的，而该网格没有给出</translation>
    </message>
    <message>
        <source>Give the mesh or organ file</source>
        <translation>请给出该网格或器官文件</translation>
    </message>
    <message>
        <source>Own organ</source>
        <translation>自备器官</translation>
    </message>
    <message>
        <source>Twist about its own axis the other way, 60 degrees</source>
        <translation>绕自身轴线反向扭转 60 度</translation>
    </message>
    <message>
        <source>Twist about its own axis, 60 degrees</source>
        <translation>绕自身轴线扭转 60 度</translation>
    </message>
    <message>
        <source>Right forearm: Pronation, 60 degrees</source>
        <translation>右前臂：旋前 60 度</translation>
    </message>
    <message>
        <source>Warning about the organ of a recording</source>
        <translation>关于录制所用器官的警告</translation>
    </message>
    <message>
        <source>Copy or export the file again</source>
        <translation>请重新复制或导出文件</translation>
    </message>
    <message>
        <source>N04 the file cannot be opened</source>
        <translation>N04 无法打开文件</translation>
    </message>
    <message>
        <source>N04 the file ends, or is damaged, after %1 of %2 voxels</source>
        <translation>N04 文件在第 %1 个体素（共 %2 个）之后结束或已损坏</translation>
    </message>
    <message>
        <source>N01 the file is shorter than a NIfTI header, or damaged</source>
        <translation>N01 文件比 NIfTI 文件头还短，或已损坏</translation>
    </message>
    <message>
        <source>Give a NIfTI-1 file, .nii or .nii.gz</source>
        <translation>请给出 NIfTI-1 文件（.nii 或 .nii.gz）</translation>
    </message>
    <message>
        <source>N04 the voxels lie in a file of their own, NAME.img beside NAME.hdr, and it is missing</source>
        <translation>N04 体素存放在单独的文件中（NAME.hdr 旁的 NAME.img），但该文件缺失</translation>
    </message>
    <message>
        <source>N04 the file ends before its voxels begin</source>
        <translation>N04 文件在体素开始之前就结束了</translation>
    </message>
    <message>
        <source>N04 the file is damaged: its check sum is wrong</source>
        <translation>N04 文件已损坏：校验和错误</translation>
    </message>
    <message>
        <source>%1 {voxel|voxels} without a number count as air</source>
        <translation>%1 个没有数值的体素按空气计</translation>
    </message>
    <message>
        <source>Check where the scan has no values</source>
        <translation>请检查扫描何处没有数值</translation>
    </message>
    <message>
        <source>N01 this is a NIfTI-2 file; NIfTI-1 is read</source>
        <translation>N01 这是 NIfTI-2 文件；只读取 NIfTI-1</translation>
    </message>
    <message>
        <source>Save it as NIfTI-1</source>
        <translation>请另存为 NIfTI-1</translation>
    </message>
    <message>
        <source>N01 this is no NIfTI file: its header does not begin with 348</source>
        <translation>N01 这不是 NIfTI 文件：文件头不以 348 开头</translation>
    </message>
    <message>
        <source>N01 the file has no NIfTI mark: an Analyze file does not say where left and right are</source>
        <translation>N01 文件没有 NIfTI 标记：Analyze 文件不说明左右方向</translation>
    </message>
    <message>
        <source>Convert the scan to NIfTI-1 again from its DICOM files</source>
        <translation>请从 DICOM 文件重新转换为 NIfTI-1</translation>
    </message>
    <message>
        <source>N02 the file has %1 dimensions, a volume has 3</source>
        <translation>N02 文件有 %1 个维度，体数据应有 3 个</translation>
    </message>
    <message>
        <source>Give one volume</source>
        <translation>请给出单个体数据</translation>
    </message>
    <message>
        <source>N02 dimension %1 is %2, it must lie between 1 and %3</source>
        <translation>N02 维度 %1 为 %2，必须在 1 到 %3 之间</translation>
    </message>
    <message>
        <source>Export the scan again</source>
        <translation>请重新导出扫描</translation>
    </message>
    <message>
        <source>N02 the file holds a series of volumes: dimension %1 is %2</source>
        <translation>N02 文件含有一系列体数据：维度 %1 为 %2</translation>
    </message>
    <message>
        <source>N03 voxels of datatype %1 (colour, complex or 64-bit whole numbers) are not read</source>
        <translation>N03 不读取数据类型为 %1 的体素（彩色、复数或 64 位整数）</translation>
    </message>
    <message>
        <source>Save the volume with 16-bit whole numbers</source>
        <translation>请以 16 位整数保存体数据</translation>
    </message>
    <message>
        <source>N03 datatype %1 with %2 bits a voxel contradicts itself</source>
        <translation>N03 数据类型 %1 与每体素 %2 位相互矛盾</translation>
    </message>
    <message>
        <source>N04 the voxels are said to begin at byte %1</source>
        <translation>N04 文件称体素从第 %1 字节开始</translation>
    </message>
    <message>
        <source>the file names no unit of length; millimetres are assumed</source>
        <translation>文件未说明长度单位；假定为毫米</translation>
    </message>
    <message>
        <source>Check the size of the organ</source>
        <translation>请检查器官的大小</translation>
    </message>
    <message>
        <source>N06 the file&apos;s unit of length is unknown</source>
        <translation>N06 文件的长度单位未知</translation>
    </message>
    <message>
        <source>Save the volume with lengths in millimetres</source>
        <translation>请以毫米为长度单位保存体数据</translation>
    </message>
    <message>
        <source>N05 the rotation of the file is none: its quaternion is %1 long</source>
        <translation>N05 文件的旋转无效：其四元数长度为 %1</translation>
    </message>
    <message>
        <source>the file does not say how the patient lay: left and right may be exchanged</source>
        <translation>文件未说明患者的体位：左右可能颠倒</translation>
    </message>
    <message>
        <source>Convert the scan again from its DICOM files</source>
        <translation>请从 DICOM 文件重新转换扫描</translation>
    </message>
    <message>
        <source>Resample the volume to voxels with right angles, or export it again</source>
        <translation>请将体数据重采样为直角体素，或重新导出</translation>
    </message>
    <message>
        <source>N05 the file lies nowhere: its origin is out of range</source>
        <translation>N05 文件没有有效位置：其原点超出范围</translation>
    </message>
    <message>
        <source>N05 voxels are %1 mm along axis %2, they must have %3 to %4 mm</source>
        <translation>N05 体素沿轴 %2 为 %1 mm，必须在 %3 到 %4 mm 之间</translation>
    </message>
    <message>
        <source>N05 the volume is sheared: two of its axes are %1 degrees off a right angle</source>
        <translation>N05 体数据被剪切：其中两轴偏离直角 %1 度</translation>
    </message>
    <message>
        <source>soft tissue between -200 and 200 HU</source>
        <translation>-200 到 200 HU 之间的软组织</translation>
    </message>
    <message>
        <source>air near -1000 HU</source>
        <translation>-1000 HU 附近的空气</translation>
    </message>
    <message>
        <source>D13 the values are not those of a CT: there is no %1</source>
        <translation>D13 数值不是 CT 的数值：没有%1</translation>
    </message>
    <message>
        <source>Give a CT in Hounsfield units, or a label mask with --tissue label N</source>
        <translation>请给出以 HU 为单位的 CT，或用 --tissue label N 给出标签掩膜</translation>
    </message>
    <message>
        <source>D15 the scan is too large: %1 x %2 x %3 voxels are %4 GB, at most %5 GB are read</source>
        <translation>D15 扫描过大：%1 x %2 x %3 个体素为 %4 GB，最多读取 %5 GB</translation>
    </message>
    <message>
        <source>Crop the scan, or export it with larger voxels</source>
        <translation>请裁剪扫描，或以更大的体素导出</translation>
    </message>
    <message>
        <source>this person has the account %1 already</source>
        <translation>此人已有账号 %1</translation>
    </message>
    <message>
        <source>Give that account the role, or switch it on again</source>
        <translation>请把角色赋予该账号，或重新启用它</translation>
    </message>
    <message>
        <source>an account of the demonstration signs only what is simulated</source>
        <translation>演示账号只能签署模拟数据</translation>
    </message>
    <message>
        <source>Let a person of the centre do it</source>
        <translation>请由本中心的真实人员完成</translation>
    </message>
    <message>
        <source>Probability of a false alarm</source>
        <translation>误报警的概率</translation>
    </message>
    <message>
        <source>Within %1 {attempt|attempts}, %2 of trainees who fail %3 of their attempts are held to be able (false pass), and %4 of those who fail only %5 are not (false fail); another %6 lost it by a false alarm.</source>
        <translation>在 %1 次尝试内，失败率为 %3 的学员中有 %2 会被误认为胜任（误通过），失败率仅为 %5 的学员中有 %4 不被认为胜任（误不通过）；另有 %6 因误报警而不再被认为胜任。</translation>
    </message>
    <message>
        <source>Not shown to differ: %1.</source>
        <translation>未显示有差异：%1。</translation>
    </message>
    <message>
        <source>%1 other pairs were not shown to differ: see the figure.</source>
        <translation>另有 %1 对未显示有差异：见图。</translation>
    </message>
    <message>
        <source>A single trainee has a score at both occasions in: %1. Its differences rest on one person; how much trainees of a group vary is taken from the other groups.</source>
        <translation>以下各组只有一名学员在两次评分时都有得分：%1。其差异仅取决于一个人；组内学员的变异取自其他组。</translation>
    </message>
    <message>
        <source>False alarm</source>
        <translation>误报警</translation>
    </message>
    <message>
        <source>the centre has set no mail server</source>
        <translation>本中心尚未设置邮件服务器</translation>
    </message>
    <message>
        <source>Set one first</source>
        <translation>请先设置</translation>
    </message>
    <message>
        <source>the mail server offers no encryption: nothing was sent</source>
        <translation>邮件服务器不提供加密：未发送任何内容</translation>
    </message>
    <message>
        <source>Choose TLS from the beginning, or ask who runs it</source>
        <translation>请选择从一开始就使用 TLS，或询问其管理者</translation>
    </message>
    <message>
        <source>somebody else speaks before the encryption of the mail server begins</source>
        <translation>在邮件服务器开始加密之前，有他人插入了内容</translation>
    </message>
    <message>
        <source>Choose TLS from the beginning, or ask who runs the network</source>
        <translation>请选择从一开始就使用 TLS，或询问网络管理者</translation>
    </message>
    <message>
        <source>the mail server takes no sign-in with a password</source>
        <translation>邮件服务器不接受密码登录</translation>
    </message>
    <message>
        <source>Take the sign-in name out of its settings, or ask who runs it</source>
        <translation>请在设置中去掉登录名，或询问其管理者</translation>
    </message>
    <message>
        <source>the mail server cannot be trusted: %1</source>
        <translation>无法信任该邮件服务器：%1</translation>
    </message>
    <message>
        <source>Check its name; the authority of its certificate must be known to this computer</source>
        <translation>请检查其名称；本机须认识其证书的颁发机构</translation>
    </message>
    <message>
        <source>it is not known whether it was taken: %1</source>
        <translation>不清楚是否已被接收：%1</translation>
    </message>
    <message>
        <source>not sent: %1</source>
        <translation>未发送：%1</translation>
    </message>
    <message>
        <source>Reminder sent by mail</source>
        <translation>已通过邮件发送提醒</translation>
    </message>
    <message>
        <source>Reminder copied</source>
        <translation>已复制提醒</translation>
    </message>
    <message>
        <source>N07 the file has no label at all</source>
        <translation>N07 文件中没有任何标签</translation>
    </message>
    <message>
        <source>N07 the file has no label %1; it has %2</source>
        <translation>N07 文件中没有标签 %1；有：%2</translation>
    </message>
    <message>
        <source>Choose one of its labels</source>
        <translation>请选择其中一个标签</translation>
    </message>
    <message>
        <source>gaps of up to %1 mm were closed, so that the surface has no handles</source>
        <translation>已闭合最宽 %1 mm 的间隙，使表面没有环柄</translation>
    </message>
    <message>
        <source>the scan does not show where the wall ends: %1 mm are assumed</source>
        <translation>扫描未显示器官壁的外缘：假定厚 %1 mm</translation>
    </message>
    <message>
        <source>Give its thickness with --wall</source>
        <translation>请用 --wall 给出其厚度</translation>
    </message>
    <message>
        <source>a label must lie between 1 and %1</source>
        <translation>标签必须在 1 到 %1 之间</translation>
    </message>
    <message>
        <source>Name a label of the mask: --tissue label N</source>
        <translation>请指定掩膜中的标签：--tissue label N</translation>
    </message>
    <message>
        <source>D16 the seed %1 lies outside of the scan or the box</source>
        <translation>D16 种子点 %1 位于扫描或方框之外</translation>
    </message>
    <message>
        <source>Give a point in millimetres: x to the left, y to the back, z up</source>
        <translation>请以毫米给出一点：x 向左，y 向后，z 向上</translation>
    </message>
    <message>
        <source>D16 no such tissue lies at the seed %1, where the scan has the value %2</source>
        <translation>D16 种子点 %1 处没有这种组织，该处扫描值为 %2</translation>
    </message>
    <message>
        <source>Give a point inside of the organ</source>
        <translation>请给出器官内部的一点</translation>
    </message>
    <message>
        <source>D16 no gas is enclosed in this scan</source>
        <translation>D16 此扫描中没有被包围的气体</translation>
    </message>
    <message>
        <source>D16 no such tissue lies in this scan</source>
        <translation>D16 此扫描中没有这种组织</translation>
    </message>
    <message>
        <source>Choose another --tissue, or another scan</source>
        <translation>请选择其他 --tissue 或其他扫描</translation>
    </message>
    <message>
        <source>D16 several spaces are filled with gas: %1</source>
        <translation>D16 有多个充气的空腔：%1</translation>
    </message>
    <message>
        <source>Name the organ with --seed x,y,z, or look at a part with --box</source>
        <translation>请用 --seed x,y,z 指定器官，或用 --box 只看一部分</translation>
    </message>
    <message>
        <source>the largest of several pieces was taken: %1</source>
        <translation>已采用多块中最大的一块：%1</translation>
    </message>
    <message>
        <source>Name another one with --seed x,y,z</source>
        <translation>可用 --seed x,y,z 指定另一块</translation>
    </message>
    <message>
        <source>D16 the tissue reaches %1 of the 6 borders of the scan: it leaks, or the scan shows a part</source>
        <translation>D16 组织触及扫描 6 个边界中的 %1 个：发生外漏，或扫描只显示了一部分</translation>
    </message>
    <message>
        <source>Give a --seed inside of the organ, or cut it out with --box</source>
        <translation>请给出器官内部的 --seed，或用 --box 裁出器官</translation>
    </message>
    <message>
        <source>D16 the gas leaks: it fills %1 ml, a stomach holds at most %2 ml</source>
        <translation>D16 气体外漏：充满 %1 ml，而胃最多容纳 %2 ml</translation>
    </message>
    <message>
        <source>the left</source>
        <translation>左侧</translation>
    </message>
    <message>
        <source>the right</source>
        <translation>右侧</translation>
    </message>
    <message>
        <source>the back</source>
        <translation>背侧</translation>
    </message>
    <message>
        <source>the front</source>
        <translation>腹侧</translation>
    </message>
    <message>
        <source>the head</source>
        <translation>头侧</translation>
    </message>
    <message>
        <source>the feet</source>
        <translation>足侧</translation>
    </message>
    <message>
        <source>the scan cuts the organ off towards %1: the flat end is none of its own</source>
        <translation>扫描在%1切断了器官：平的一端不是器官本身的末端</translation>
    </message>
    <message>
        <source>Name it as an end of the organ, or give a scan that shows all of it</source>
        <translation>请将其指定为器官的一端，或给出显示整个器官的扫描</translation>
    </message>
    <message>
        <source>D16 the box lies beside the scan, or holds nothing of it</source>
        <translation>D16 方框位于扫描之外，或不含扫描的任何部分</translation>
    </message>
    <message>
        <source>Give two opposite corners in millimetres: x to the left, y to the back, z up</source>
        <translation>请以毫米给出两个对角：x 向左，y 向后，z 向上</translation>
    </message>
    <message>
        <source>this account may not sign in</source>
        <translation>此账户不可登录</translation>
    </message>
    <message>
        <source>Enable it first, or leave it out</source>
        <translation>请先启用该账户，或不选择它</translation>
    </message>
    <message>
        <source>Change your password where you are signed in</source>
        <translation>请在您登录的地方修改密码</translation>
    </message>
    <message>
        <source>browsers cannot reach the review desk at this address</source>
        <translation>浏览器无法通过此地址访问评分台</translation>
    </message>
    <message>
        <source>Write it as https://desk.example.org</source>
        <translation>请写成 https://desk.example.org 的形式</translation>
    </message>
    <message>
        <source>invitations</source>
        <translation>登录邀请</translation>
    </message>
    <message>
        <source>Choose at least one user</source>
        <translation>请至少选择一名用户</translation>
    </message>
    <message>
        <source>an invitation is taken back with a reason only</source>
        <translation>撤回登录邀请必须说明原因</translation>
    </message>
    <message>
        <source>this evaluation does not ask for you</source>
        <translation>此评价未邀请您参加</translation>
    </message>
    <message>
        <source>this session is over</source>
        <translation>此会话已结束</translation>
    </message>
    <message>
        <source>there is no page for you in the browser</source>
        <translation>浏览器中没有适合您的页面</translation>
    </message>
    <message>
        <source>this invitation is not good, or not any more</source>
        <translation>此登录邀请无效或已失效</translation>
    </message>
    <message>
        <source>Look at the link again, or ask an administrator for a new one</source>
        <translation>请核对链接，或向管理员索取新的链接</translation>
    </message>
    <message>
        <source>%1 min ago</source>
        <translation>%1 分钟前</translation>
    </message>
    <message>
        <source>%1 of %2 on target</source>
        <translation>%1/%2 达标</translation>
    </message>
    <message>
        <source>%1 over %2 tries: first %3, last %4</source>
        <translation>%1，共 %2 次：首次 %3，最近 %4</translation>
    </message>
    <message>
        <source>%1 recording now, %2 of %3 done, sheets missing: %4</source>
        <translation>%1 人正在录制，%2/%3 人已完成，缺评分表：%4</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 {twist was|twists were} not completed.</source>
        <translation>%1 次扭转未完成。</translation>
    </message>
    <message>
        <source>%1. Model %2</source>
        <translation>%1. 模型 %2</translation>
    </message>
    <message>
        <source>%1. Model %2, submitted</source>
        <translation>%1. 模型 %2，已提交</translation>
    </message>
    <message>
        <source>%1: mastered</source>
        <translation>%1：已掌握</translation>
    </message>
    <message>
        <source>95 % interval %1 to %2; cases: %3. Your mean is %4, the others&apos; %5.</source>
        <translation>95 % 区间 %1 至 %2；案例数：%3。您的均分 %4，他人 %5。</translation>
    </message>
    <message>
        <source>a physician</source>
        <translation>一位医师</translation>
    </message>
    <message>
        <source>All are scored. Press again to seal them; sealed marks stay as they are.</source>
        <translation>均已评分。再按一次即封存；封存后的评分不再改变。</translation>
    </message>
    <message>
        <source>All models are submitted. Thank you.</source>
        <translation>所有模型均已提交，谢谢。</translation>
    </message>
    <message>
        <source>all phases done</source>
        <translation>全部阶段已完成</translation>
    </message>
    <message>
        <source>An untwisting: the traces show how the organ fared.</source>
        <translation>解除扭转：曲线显示器官的状况。</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>答复</translation>
    </message>
    <message>
        <source>Asked for</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>At %1</source>
        <translation>在 %1</translation>
    </message>
    <message>
        <source>Blood flow</source>
        <translation>血流</translation>
    </message>
    <message>
        <source>Bookmarks</source>
        <translation>书签</translation>
    </message>
    <message>
        <source>Browser</source>
        <translation>浏览器</translation>
    </message>
    <message>
        <source>Cases appear here once all physicians have submitted them.</source>
        <translation>所有医师提交后，案例会显示在这里。</translation>
    </message>
    <message>
        <source>Choose a password that only you know: at least fifteen characters, a short sentence for example. The link is good once.</source>
        <translation>请设置只有您知道的密码：至少十五个字符，例如一个短句。此链接只能使用一次。</translation>
    </message>
    <message>
        <source>Compare with the panel</source>
        <translation>与专家组比较</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差值</translation>
    </message>
    <message>
        <source>does not answer</source>
        <translation>无响应</translation>
    </message>
    <message>
        <source>Dose</source>
        <translation>剂量</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>已修改</translation>
    </message>
    <message>
        <source>End</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>End the session: %1</source>
        <translation>结束会话：%1</translation>
    </message>
    <message>
        <source>Everything that you have done, to print or to keep. That it was made is noted in the audit trail.</source>
        <translation>您的全部训练记录，可打印或保存。生成成绩单会记入审计记录。</translation>
    </message>
    <message>
        <source>For your eyes only: overall marks of cases that all have submitted. The mean of the others does not hold your own mark.</source>
        <translation>仅供您本人查看：所有人均已提交的案例的总评。他人均分不含您自己的评分。</translation>
    </message>
    <message>
        <source>From</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>From one case; an interval needs two at least.</source>
        <translation>仅有一个案例；区间至少需要两个。</translation>
    </message>
    <message>
        <source>Go on with reference %1</source>
        <translation>继续参考操作 %1</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>I have read it</source>
        <translation>我已阅读</translation>
    </message>
    <message>
        <source>just now</source>
        <translation>刚刚</translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation>最近在线</translation>
    </message>
    <message>
        <source>Last used</source>
        <translation>最近使用</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Let go at</source>
        <translation>松开角度</translation>
    </message>
    <message>
        <source>Lumen</source>
        <translation>管腔</translation>
    </message>
    <message>
        <source>Made on %1 with Torsio %2. A training record, no certificate of clinical competence.</source>
        <translation>由 Torsio %2 于 %1 生成。本记录为训练记录，不是临床能力证明。</translation>
    </message>
    <message>
        <source>Make the transcript</source>
        <translation>生成成绩单</translation>
    </message>
    <message>
        <source>Model %1 is submitted and sealed</source>
        <translation>模型 %1 已提交并封存</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>My severity</source>
        <translation>我的严格度</translation>
    </message>
    <message>
        <source>new</source>
        <translation>新</translation>
    </message>
    <message>
        <source>Nine indices for each model. Which model stands behind a letter is hidden, and the order is your own.</source>
        <translation>每个模型九项指标。字母代表哪个模型不公开，顺序因人而异。</translation>
    </message>
    <message>
        <source>No evaluation asks for you at present.</source>
        <translation>目前没有需要您参加的评价。</translation>
    </message>
    <message>
        <source>No reference run has been chosen yet. You may begin with your queue.</source>
        <translation>尚未选定参考操作，您可以直接从队列开始。</translation>
    </message>
    <message>
        <source>No try has this figure yet.</source>
        <translation>尚无任何尝试具有此数值。</translation>
    </message>
    <message>
        <source>Nobody has written anything yet. Remarks appear when the marks are released.</source>
        <translation>尚无评语。评语在评分公布后显示。</translation>
    </message>
    <message>
        <source>not asked</source>
        <translation>未邀请</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>未通过</translation>
    </message>
    <message>
        <source>Nothing to compare yet.</source>
        <translation>暂无可比较的内容。</translation>
    </message>
    <message>
        <source>Nothing was recorded yet.</source>
        <translation>尚无录制。</translation>
    </message>
    <message>
        <source>Now at</source>
        <translation>当前阶段</translation>
    </message>
    <message>
        <source>On to the queue</source>
        <translation>前往队列</translation>
    </message>
    <message>
        <source>open</source>
        <translation>未开始</translation>
    </message>
    <message>
        <source>Over all reference runs: %1 points from the panel. You may score a run again; every try is kept.</source>
        <translation>全部参考操作：与专家组相差 %1 分。您可以重新评分，每次尝试均保留。</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>页面</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>专家组</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>已安排</translation>
    </message>
    <message>
        <source>points from the panel: you are milder.</source>
        <translation>分，与专家组之差：您较宽松。</translation>
    </message>
    <message>
        <source>points from the panel: you are stricter.</source>
        <translation>分，与专家组之差：您较严格。</translation>
    </message>
    <message>
        <source>points from the panel: you judge as the others do.</source>
        <translation>分，与专家组之差：您与他人判断一致。</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>压力</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>打印</translation>
    </message>
    <message>
        <source>records at %1</source>
        <translation>在 %1 录制</translation>
    </message>
    <message>
        <source>Reference %1</source>
        <translation>参考 %1</translation>
    </message>
    <message>
        <source>Reference %1, scored</source>
        <translation>参考 %1，已评</translation>
    </message>
    <message>
        <source>Reference runs</source>
        <translation>参考操作</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>评语</translation>
    </message>
    <message>
        <source>Score each run before you see what the panel has said. It counts for nothing but yourself.</source>
        <translation>先为每次操作评分，再看专家组的评分。结果只供您自己参考。</translation>
    </message>
    <message>
        <source>Score first; then the panel&apos;s mark is shown.</source>
        <translation>请先评分，然后显示专家组的评分。</translation>
    </message>
    <message>
        <source>Scoring due</source>
        <translation>待评分时点</translation>
    </message>
    <message>
        <source>Sheets missing</source>
        <translation>缺评分表</translation>
    </message>
    <message>
        <source>Signed in now</source>
        <translation>当前登录</translation>
    </message>
    <message>
        <source>Simulated people</source>
        <translation>模拟人员</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>工作站</translation>
    </message>
    <message>
        <source>Stations</source>
        <translation>工作站</translation>
    </message>
    <message>
        <source>Still open</source>
        <translation>尚未完成</translation>
    </message>
    <message>
        <source>Submit this model</source>
        <translation>提交此模型</translation>
    </message>
    <message>
        <source>That is as the panel sees it.</source>
        <translation>与专家组看法一致。</translation>
    </message>
    <message>
        <source>The code that you were given besides the link</source>
        <translation>链接之外另行交给您的代码</translation>
    </message>
    <message>
        <source>The session was ended</source>
        <translation>会话已结束</translation>
    </message>
    <message>
        <source>There is no cohort yet.</source>
        <translation>尚无批次。</translation>
    </message>
    <message>
        <source>There is no recording of this model here: score what you have met at the station.</source>
        <translation>此处没有该模型的录制：请按您在工作站的体验评分。</translation>
    </message>
    <message>
        <source>this one</source>
        <translation>当前会话</translation>
    </message>
    <message>
        <source>Time left</source>
        <translation>剩余时间</translation>
    </message>
    <message>
        <source>To the first page</source>
        <translation>返回首页</translation>
    </message>
    <message>
        <source>Today&apos;s sessions</source>
        <translation>今日训练</translation>
    </message>
    <message>
        <source>Transcript</source>
        <translation>成绩单</translation>
    </message>
    <message>
        <source>tries left: %1</source>
        <translation>剩余次数：%1</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Virtual %1 min, real arm %2 min, rest %3 min</source>
        <translation>虚拟 %1 分钟，实臂 %2 分钟，休息 %3 分钟</translation>
    </message>
    <message>
        <source>wanted: %1</source>
        <translation>要求：%1</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>欢迎</translation>
    </message>
    <message>
        <source>What physicians wrote at moments of your runs. Who it was is not told.</source>
        <translation>医师针对您操作中某些时刻写下的评语，不透露作者。</translation>
    </message>
    <message>
        <source>What stands in the link behind the #</source>
        <translation>链接中 # 之后的内容</translation>
    </message>
    <message>
        <source>Where you are signed in with a browser. End what you do not know, then change your password.</source>
        <translation>您在哪些浏览器中登录。请结束您不认识的会话，然后修改密码。</translation>
    </message>
    <message>
        <source>Who has scored what</source>
        <translation>评分进度</translation>
    </message>
    <message>
        <source>Whoever is signed in with a browser. Ending a session keeps every draft; the person can sign in again.</source>
        <translation>所有通过浏览器登录的人。结束会话不会丢失任何草稿，本人可再次登录。</translation>
    </message>
    <message>
        <source>withdrew</source>
        <translation>已退出</translation>
    </message>
    <message>
        <source>without felt force</source>
        <translation>无力反馈</translation>
    </message>
    <message>
        <source>You</source>
        <translation>您</translation>
    </message>
    <message>
        <source>you</source>
        <translation>您</translation>
    </message>
    <message>
        <source>You and the panel</source>
        <translation>您与专家组</translation>
    </message>
    <message>
        <source>You are milder by %1.</source>
        <translation>您宽松了 %1 分。</translation>
    </message>
    <message>
        <source>You are stricter by %1.</source>
        <translation>您严格了 %1 分。</translation>
    </message>
    <message>
        <source>You may score it again, or go on with the next run.</source>
        <translation>您可以重新评分，或继续下一个操作。</translation>
    </message>
    <message>
        <source>You: %1. Panel of %2: %3.</source>
        <translation>您：%1。%2 人专家组：%3。</translation>
    </message>
    <message>
        <source>Your answer</source>
        <translation>您的答复</translation>
    </message>
    <message>
        <source>Your cases that wait for the others: %1.</source>
        <translation>等待他人提交的案例：%1。</translation>
    </message>
    <message>
        <source>Your record</source>
        <translation>您的记录</translation>
    </message>
    <message>
        <source>Your runs</source>
        <translation>您的操作</translation>
    </message>
    <message>
        <source>Your sessions</source>
        <translation>您的会话</translation>
    </message>
    <message>
        <source>Your sign-in name is %1: with it and your password you come in the next time.</source>
        <translation>您的登录名是 %1：下次用它和您的密码登录。</translation>
    </message>
    <message>
        <source>● submitted, ◐ draft, ○ open. No marks are shown here.</source>
        <translation>● 已提交，◐ 草稿，○ 未开始。此处不显示评分。</translation>
    </message>
    <message>
        <source>Invitation made</source>
        <translation>已生成登录邀请</translation>
    </message>
    <message>
        <source>Invitation revoked</source>
        <translation>已撤销登录邀请</translation>
    </message>
    <message>
        <source>Password set by an invitation</source>
        <translation>已通过登录邀请设置密码</translation>
    </message>
    <message>
        <source>Sessions in browsers ended</source>
        <translation>已结束浏览器会话</translation>
    </message>
    <message>
        <source>Invitation</source>
        <translation>登录邀请</translation>
    </message>
    <message>
        <source>Reading the scan</source>
        <translation>正在读取扫描</translation>
    </message>
    <message>
        <source>Looking for the organ</source>
        <translation>正在寻找器官</translation>
    </message>
    <message>
        <source>Drawing its surface</source>
        <translation>正在绘制其表面</translation>
    </message>
    <message>
        <source>Smoothing and thinning</source>
        <translation>正在平滑和简化</translation>
    </message>
    <message>
        <source>Measuring the wall</source>
        <translation>正在测量器官壁</translation>
    </message>
    <message>
        <source>D15 the scan needs more than %1 MB of memory</source>
        <translation>D15 扫描需要超过 %1 MB 的内存</translation>
    </message>
    <message>
        <source>D04 the reader failed on this scan</source>
        <translation>D04 读取程序无法处理此扫描</translation>
    </message>
    <message>
        <source>Copy or export the scan again</source>
        <translation>请重新复制或导出扫描</translation>
    </message>
    <message>
        <source>D04 the reader gave no answer to this scan</source>
        <translation>D04 读取程序对此扫描没有答复</translation>
    </message>
    <message>
        <source>D04 the program that reads scans cannot be started: %1</source>
        <translation>D04 读取扫描的程序无法启动：%1</translation>
    </message>
    <message>
        <source>D04 the reader did not come to an end with this scan within %1 s</source>
        <translation>D04 读取程序在 %1 秒内未能处理完此扫描</translation>
    </message>
    <message>
        <source>Crop the scan to the organ</source>
        <translation>请将扫描裁剪到器官范围</translation>
    </message>
    <message>
        <source>D04 the reader crashed on this scan (signal %1)</source>
        <translation>D04 读取程序在处理此扫描时崩溃（信号 %1）</translation>
    </message>
    <message>
        <source>D04 the system gives no memory to read the scan</source>
        <translation>D04 系统没有可用内存来读取扫描</translation>
    </message>
    <message>
        <source>D15 the folder holds more than %1 files</source>
        <translation>D15 文件夹中的文件超过 %1 个</translation>
    </message>
    <message>
        <source>Give the folder of one scan</source>
        <translation>请给出一次扫描的文件夹</translation>
    </message>
    <message>
        <source>D01 there is no DICOM file in this folder</source>
        <translation>D01 此文件夹中没有 DICOM 文件</translation>
    </message>
    <message>
        <source>D04 file %1 is damaged or cut short</source>
        <translation>D04 文件 %1 已损坏或不完整</translation>
    </message>
    <message>
        <source>Give a folder of DICOM files, or a NIfTI file</source>
        <translation>请给出 DICOM 文件夹或 NIfTI 文件</translation>
    </message>
    <message>
        <source>D02 there is no CT series in this folder: %1</source>
        <translation>D02 此文件夹中没有 CT 序列：%1</translation>
    </message>
    <message>
        <source>Give a folder with the slices of a CT</source>
        <translation>请给出包含 CT 层面的文件夹</translation>
    </message>
    <message>
        <source>series %1: %2 slices of %3 x %4</source>
        <translation>序列 %1：%2 层，%3 x %4</translation>
    </message>
    <message>
        <source>D03 there is no series %1: %2</source>
        <translation>D03 没有序列 %1：%2</translation>
    </message>
    <message>
        <source>Choose one with --series N</source>
        <translation>请用 --series N 选择一个</translation>
    </message>
    <message>
        <source>series %1 was taken, the one with the most slices: %2</source>
        <translation>已采用层数最多的序列 %1：%2</translation>
    </message>
    <message>
        <source>Choose another one with --series N</source>
        <translation>可用 --series N 选择另一个</translation>
    </message>
    <message>
        <source>D05 slice %1 is compressed with JPEG 2000 (%2), which is not read</source>
        <translation>D05 层面 %1 以 JPEG 2000 (%2) 压缩，无法读取</translation>
    </message>
    <message>
        <source>D05 slice %1 is compressed in a way that is not read (%2)</source>
        <translation>D05 层面 %1 的压缩方式无法读取 (%2)</translation>
    </message>
    <message>
        <source>Export the scan without compression, or convert each file with gdcmconv --raw</source>
        <translation>请不压缩地导出扫描，或用 gdcmconv --raw 逐个转换文件</translation>
    </message>
    <message>
        <source>Export the slices of the CT themselves</source>
        <translation>请导出 CT 的原始层面</translation>
    </message>
    <message>
        <source>D12 slice %1 holds %2 frames</source>
        <translation>D12 层面 %1 含有 %2 帧</translation>
    </message>
    <message>
        <source>Export the scan with one slice a file</source>
        <translation>请以每个文件一层的方式导出扫描</translation>
    </message>
    <message>
        <source>D12 slice %1 has %2 {bit|bits} a value and %3 {value|values} a pixel; 16 and 1 are read</source>
        <translation>D12 层面 %1 每个值 %2 位、每个像素 %3 个值；只读取 16 位、1 个值</translation>
    </message>
    <message>
        <source>D06 slice %1 has no valid size or depth: %2 x %3 pixels, %4 bits</source>
        <translation>D06 层面 %1 的尺寸或位深无效：%2 x %3 像素，%4 位</translation>
    </message>
    <message>
        <source>D06 slice %1 has no valid %2</source>
        <translation>D06 层面 %1 没有有效的 %2</translation>
    </message>
    <message>
        <source>Export the scan again with its geometry</source>
        <translation>请连同几何信息重新导出扫描</translation>
    </message>
    <message>
        <source>D07 slice %1 has another size, spacing or orientation than slice %2</source>
        <translation>D07 层面 %1 的尺寸、间距或方向与层面 %2 不同</translation>
    </message>
    <message>
        <source>Give one series of one scan</source>
        <translation>请给出一次扫描的一个序列</translation>
    </message>
    <message>
        <source>slices have scales of their own; each was taken by its own</source>
        <translation>各层面有各自的换算系数；已按各自的系数换算</translation>
    </message>
    <message>
        <source>D04 slice %1 is damaged or cut short: its pixels cannot be read</source>
        <translation>D04 层面 %1 已损坏或不完整：无法读取其像素</translation>
    </message>
    <message>
        <source>D08 slices %1 and %2 lie at the same place and differ</source>
        <translation>D08 层面 %1 和 %2 位于同一位置但内容不同</translation>
    </message>
    <message>
        <source>%1 {slice|slices} that were there twice left out</source>
        <translation>已略去 %1 个重复的层面</translation>
    </message>
    <message>
        <source>Check that the scan is whole</source>
        <translation>请检查扫描是否完整</translation>
    </message>
    <message>
        <source>D09 the slices lie unevenly: %1 mm between %2 and %3, elsewhere %4 mm</source>
        <translation>D09 层面间距不均匀：%2 与 %3 之间为 %1 mm，其他处为 %4 mm</translation>
    </message>
    <message>
        <source>Look for slices that are missing, or take them as they are with --resample</source>
        <translation>请查找缺失的层面，或用 --resample 按现状采用</translation>
    </message>
    <message>
        <source>the slices lie unevenly, up to %1 mm apart: what lies in between is guessed</source>
        <translation>层面间距不均匀，最大相距 %1 mm：其间的内容为推算</translation>
    </message>
    <message>
        <source>Give a scan with slices at even distances</source>
        <translation>请给出层面间距均匀的扫描</translation>
    </message>
    <message>
        <source>D07 slice %1 is shifted by %2 mm against the others</source>
        <translation>D07 层面 %1 相对其他层面偏移 %2 mm</translation>
    </message>
    <message>
        <source>D10 the gantry was tilted by %1 degrees, at most %2 are corrected</source>
        <translation>D10 机架倾斜 %1 度，最多校正 %2 度</translation>
    </message>
    <message>
        <source>Give a scan with an upright gantry</source>
        <translation>请给出机架垂直的扫描</translation>
    </message>
    <message>
        <source>the gantry was tilted by %1 degrees; the voxels lean so much</source>
        <translation>机架倾斜 %1 度；体素随之倾斜</translation>
    </message>
    <message>
        <source>the scan is coarse: voxels of %1 x %2 x %3 mm</source>
        <translation>扫描较粗：体素为 %1 x %2 x %3 mm</translation>
    </message>
    <message>
        <source>Give a series with thinner slices</source>
        <translation>请给出层厚更薄的序列</translation>
    </message>
    <message>
        <source>D11 the series has %1 {slice|slices} at different places, at least %2 are needed</source>
        <translation>D11 该序列只有 %1 个不同位置的层面，至少需要 %2 个</translation>
    </message>
    <message>
        <source>Give a whole series</source>
        <translation>请给出完整的序列</translation>
    </message>
    <message>
        <source>N01 this is no scan that is read</source>
        <translation>N01 这不是可读取的扫描</translation>
    </message>
    <message>
        <source>Give a folder of DICOM files, or a NIfTI file (.nii, .nii.gz)</source>
        <translation>请给出 DICOM 文件夹或 NIfTI 文件（.nii、.nii.gz）</translation>
    </message>
    <message>
        <source>N07 a CT has no labels</source>
        <translation>N07 CT 没有标签</translation>
    </message>
    <message>
        <source>Give the label mask, a NIfTI file</source>
        <translation>请给出标签掩膜（NIfTI 文件）</translation>
    </message>
    <message>
        <source>the scan</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>the centre sends no learning records</source>
        <translation>中心不发送学习记录</translation>
    </message>
    <message>
        <source>Turn it on under Learning records, or by torsio xapi set --on</source>
        <translation>请在“学习记录”中开启，或使用 torsio xapi set --on</translation>
    </message>
    <message>
        <source>this station has no key of the learning record store</source>
        <translation>此工作站没有学习记录库的密钥</translation>
    </message>
    <message>
        <source>Set it under Learning records, or by torsio xapi key --user NAME</source>
        <translation>请在“学习记录”中设置，或使用 torsio xapi key --user NAME</translation>
    </message>
    <message>
        <source>the key is refused: %1</source>
        <translation>密钥被拒绝：%1</translation>
    </message>
    <message>
        <source>there is no learning record store at this address: %1</source>
        <translation>此地址没有学习记录库：%1</translation>
    </message>
    <message>
        <source>the store had it already</source>
        <translation>学习记录库已有此记录</translation>
    </message>
    <message>
        <source>the store has another statement under this id</source>
        <translation>学习记录库在此标识下已有另一条记录</translation>
    </message>
    <message>
        <source>the store knows the id, but the statement cannot be read yet</source>
        <translation>学习记录库已知此标识，但该记录尚不能读取</translation>
    </message>
    <message>
        <source>taken</source>
        <translation>已接收</translation>
    </message>
    <message>
        <source>what answers is no learning record store: %1</source>
        <translation>应答的不是学习记录库：%1</translation>
    </message>
    <message>
        <source>this is no address of a web server</source>
        <translation>这不是网络服务器的地址</translation>
    </message>
    <message>
        <source>Write it like https://lrs.example.org/xapi</source>
        <translation>请写成 https://lrs.example.org/xapi 的形式</translation>
    </message>
    <message>
        <source>without encryption learning records go to a server on this computer only</source>
        <translation>不加密时，学习记录只能发往本机上的服务器</translation>
    </message>
    <message>
        <source>Use an address that begins with https://</source>
        <translation>请使用以 https:// 开头的地址</translation>
    </message>
    <message>
        <source>Ask the learning record store for a new one</source>
        <translation>请向学习记录库申请新密钥</translation>
    </message>
    <message>
        <source>is no key of a learning record store</source>
        <translation>不是学习记录库的密钥</translation>
    </message>
    <message>
        <source>Set it anew</source>
        <translation>请重新设置</translation>
    </message>
    <message>
        <source>this is no name and secret for a learning record store</source>
        <translation>这不是学习记录库的名称和密码</translation>
    </message>
    <message>
        <source>Enter both as the store shows them, the name without a colon</source>
        <translation>请按学习记录库所示输入两者，名称中不要有冒号</translation>
    </message>
    <message>
        <source>Enrolled</source>
        <translation>已登记</translation>
    </message>
    <message>
        <source>Run completed</source>
        <translation>练习完成</translation>
    </message>
    <message>
        <source>Passed or failed</source>
        <translation>通过或未通过</translation>
    </message>
    <message>
        <source>Rest taken</source>
        <translation>已休息</translation>
    </message>
    <message>
        <source>waits</source>
        <translation>等待中</translation>
    </message>
    <message>
        <source>delivered</source>
        <translation>已送达</translation>
    </message>
    <message>
        <source>refused for good</source>
        <translation>被彻底拒绝</translation>
    </message>
    <message>
        <source>Staff or student number</source>
        <translation>工号或学号</translation>
    </message>
    <message>
        <source>Full name</source>
        <translation>姓名</translation>
    </message>
    <message>
        <source>E-mail</source>
        <translation>电子邮箱</translation>
    </message>
    <message>
        <source>Experience</source>
        <translation>经验</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>年龄</translation>
    </message>
    <message>
        <source>Handedness</source>
        <translation>惯用手</translation>
    </message>
    <message>
        <source>Class of rater</source>
        <translation>评分者类别</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>缺少%1</translation>
    </message>
    <message>
        <source>the wall is %1 mm thick in the median, %2 to %3 mm in eight tenths, over the %4 % of the surface where its end is seen</source>
        <translation>在可见外缘的 %4 % 表面上，器官壁厚度中位数为 %1 mm，其中十分之八为 %2 到 %3 mm</translation>
    </message>
    <message>
        <source>the data set cannot be given its name: %1</source>
        <translation>无法为数据集命名：%1</translation>
    </message>
    <message>
        <source>An adjudicator has been requested</source>
        <translation>已请求仲裁评分者</translation>
    </message>
    <message>
        <source>Ask for an adjudicator</source>
        <translation>请求仲裁评分者</translation>
    </message>
    <message>
        <source>Discrepancy review</source>
        <translation>评分分歧复核</translation>
    </message>
    <message>
        <source>Keep my mark</source>
        <translation>保留我的评分</translation>
    </message>
    <message>
        <source>Look at it again, or move the mark</source>
        <translation>再次查看，或调整评分</translation>
    </message>
    <message>
        <source>Lowest to highest</source>
        <translation>最低至最高</translation>
    </message>
    <message>
        <source>Mean of the others</source>
        <translation>他人均分</translation>
    </message>
    <message>
        <source>No disagreement waits for you.</source>
        <translation>没有待处理的分歧。</translation>
    </message>
    <message>
        <source>Only cases that all have submitted, and only where your mark lies apart from the others. Nobody is named.</source>
        <translation>只列出所有人均已提交、且您的评分与他人相差较大的案例，不透露任何人的姓名。</translation>
    </message>
    <message>
        <source>Reason (needed to move a mark or to ask for an adjudicator)</source>
        <translation>理由（调整评分或请求仲裁评分者时必填）</translation>
    </message>
    <message>
        <source>to be decided</source>
        <translation>待决定</translation>
    </message>
    <message>
        <source>Your mark stays as it is</source>
        <translation>您的评分保持不变</translation>
    </message>
    <message>
        <source>Second intake (demonstration)</source>
        <translation>第二批学员（演示）</translation>
    </message>
    <message>
        <source>Three tissue models, second reading (demonstration)</source>
        <translation>三种组织模型，第二次评价（演示）</translation>
    </message>
    <message>
        <source>Nine-index evaluation (demonstration)</source>
        <translation>九项指标评价（演示）</translation>
    </message>
    <message>
        <source>Twist training, three arms (demonstration)</source>
        <translation>扭转训练，三组（演示）</translation>
    </message>
    <message>
        <source>First steps (demonstration)</source>
        <translation>入门（演示）</translation>
    </message>
    <message>
        <source>Volvulus and torsion (demonstration)</source>
        <translation>肠胃扭转与睾丸扭转（演示）</translation>
    </message>
    <message>
        <source>the scale of the scores is not usable</source>
        <translation>评分量表无法使用</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>量表</translation>
    </message>
    <message>
        <source>Give a lowest mark below the highest, and 1 to 1000 steps a point</source>
        <translation>最低分须低于最高分，每分 1 至 1000 级</translation>
    </message>
    <message>
        <source>Able now: at every exercise that was tried, by the designs of the section Competence. Whoever is inadequate at one is held to be able in at most %1 %, whoever is adequate at all is not in at most %2 % of cases, within the attempts named there.</source>
        <translation>目前胜任：按“胜任”一节的标准，在所有尝试过的练习中均被认为胜任。在该节所列的尝试次数内，对其中某项能力不足者被误判为胜任的概率至多为 %1 %，对各项能力均足够者未被判为胜任的概率至多为 %2 %。</translation>
    </message>
    <message>
        <source>a program that was ended left a change half done</source>
        <translation>某个被中止的程序留下了未完成的更改</translation>
    </message>
    <message>
        <source>Open it with Torsio once, which takes the change back</source>
        <translation>请用 Torsio 打开一次，未完成的更改即会撤销</translation>
    </message>
    <message>
        <source>Drawing the organ</source>
        <translation>正在绘制器官</translation>
    </message>
    <message>
        <source>Judging the organ</source>
        <translation>正在评判器官</translation>
    </message>
    <message>
        <source>Reading the mesh</source>
        <translation>正在读取网格</translation>
    </message>
    <message>
        <source>the strokes of the brush are too many or too large</source>
        <translation>画笔的笔画过多或过大</translation>
    </message>
    <message>
        <source>Mend the mask with fewer strokes</source>
        <translation>请用较少的笔画修补掩膜</translation>
    </message>
    <message>
        <source>the mask was mended by hand: %1 ml added, %2 ml taken away</source>
        <translation>掩膜经手工修补：增加 %1 ml，去除 %2 ml</translation>
    </message>
    <message>
        <source>D16 the brush took all of the organ away</source>
        <translation>D16 画笔擦去了整个器官</translation>
    </message>
    <message>
        <source>Undo some of its strokes</source>
        <translation>请撤销部分笔画</translation>
    </message>
    <message>
        <source>Leave out --fluid and mend the mask with the brush, or give a label mask</source>
        <translation>请不加 --fluid 并用画笔修补掩膜，或给出标签掩膜</translation>
    </message>
    <message>
        <source>D16 the fluid below the gas (%1 HU) is as dense as the wall (%2 HU)</source>
        <translation>D16 气体下方的液体（%1 HU）与壁（%2 HU）密度相同</translation>
    </message>
    <message>
        <source>D16 no fluid was found below the level at which the gas ends</source>
        <translation>D16 在气体终止的平面以下未找到液体</translation>
    </message>
    <message>
        <source>D16 the fluid leaks: it reaches the borders of the scan</source>
        <translation>D16 液体泄漏：到达扫描的边界</translation>
    </message>
    <message>
        <source>D16 the gas ends at no flat level: no fluid stands below it</source>
        <translation>D16 气体没有终止于平面：其下方没有液体</translation>
    </message>
    <message>
        <source>D16 the fluid leaks: with the gas it fills %1 ml, a stomach holds at most %2 ml</source>
        <translation>D16 液体泄漏：连同气体共 %1 ml，而胃最多容纳 %2 ml</translation>
    </message>
    <message>
        <source>%1 ml of fluid (%2 HU) below the gas, towards %3, were joined to it</source>
        <translation>气体下方（朝%3）的 %1 ml 液体（%2 HU）已并入</translation>
    </message>
    <message>
        <source>Look at the mask over the slices</source>
        <translation>请在切片上查看掩膜</translation>
    </message>
    <message>
        <source>fluid stands below gas only</source>
        <translation>只有气体下方才有液体</translation>
    </message>
    <message>
        <source>Choose gas or the wall as the tissue, or leave the fluid out</source>
        <translation>请选择气体或壁作为组织，或不包括液体</translation>
    </message>
    <message>
        <source>the table was cut off at y = %1 mm; where the body lay on it, it is flat there</source>
        <translation>检查床在 y = %1 mm 处切除；身体与床接触处因此是平的</translation>
    </message>
    <message>
        <source>D16 nothing in this scan is denser than %1 HU</source>
        <translation>D16 扫描中没有密度高于 %1 HU 的物体</translation>
    </message>
    <message>
        <source>Give a lower threshold, or another scan</source>
        <translation>请给出较低的阈值，或另一个扫描</translation>
    </message>
    <message>
        <source>the jaws are taken to turn about their broad side, %1, %2, %3 in the scan</source>
        <translation>假定钳口绕其宽边转动，在扫描中方向为 %1、%2、%3</translation>
    </message>
    <message>
        <source>Give the axis of the hinge where it is another</source>
        <translation>若铰链轴不同，请给出</translation>
    </message>
    <message>
        <source>the jaws are %1 mm long; the force is computed with jaws of %2 mm</source>
        <translation>钳口长 %1 mm；力按 %2 mm 的钳口计算</translation>
    </message>
    <message>
        <source>Use the instrument for what is seen</source>
        <translation>请仅将该器械用于显示</translation>
    </message>
    <message>
        <source>what is said of the instrument is out of range</source>
        <translation>关于器械的参数超出范围</translation>
    </message>
    <message>
        <source>Give a threshold of -500 to 3000 HU, a hinge 3 to 100 mm behind the tip, and directions that are not zero</source>
        <translation>请给出 -500 至 3000 HU 的阈值、距尖端 3 至 100 mm 的铰链，以及非零的方向</translation>
    </message>
    <message>
        <source>D16 what is denser than %1 HU is %2 mm long: no instrument with jaws of %3 mm</source>
        <translation>D16 密度高于 %1 HU 的物体长 %2 mm：不是钳口长 %3 mm 的器械</translation>
    </message>
    <message>
        <source>Give another threshold, a seed in the instrument, or its hinge</source>
        <translation>请给出另一个阈值、器械内的种子点或铰链位置</translation>
    </message>
    <message>
        <source>D16 the instrument has no two jaws in front of its hinge</source>
        <translation>D16 铰链之前没有两片钳口</translation>
    </message>
    <message>
        <source>Give the hinge, its axis, and a point near the tip</source>
        <translation>请给出铰链、其轴线和尖端附近的一点</translation>
    </message>
    <message>
        <source>%1 is %2 mm; an instrument has %3 to %4 mm</source>
        <translation>%1为 %2 mm；器械应为 %3 至 %4 mm</translation>
    </message>
    <message>
        <source>Check threshold, tip and hinge of the instrument</source>
        <translation>请检查阈值、尖端和铰链</translation>
    </message>
    <message>
        <source>its length</source>
        <translation>其长度</translation>
    </message>
    <message>
        <source>the radius of its tip</source>
        <translation>其尖端半径</translation>
    </message>
    <message>
        <source>the reach of its grip</source>
        <translation>其夹持范围</translation>
    </message>
    <message>
        <source>only &quot;leave out&quot; is known here, and only of tables</source>
        <translation>此处只能写“leave out”，且只适用于表格</translation>
    </message>
    <message>
        <source>Take it out: lines without a pose are refused then</source>
        <translation>请删去：没有位姿的行会被拒绝</translation>
    </message>
    <message>
        <source>what came is no OpenIGTLink</source>
        <translation>收到的内容不是 OpenIGTLink</translation>
    </message>
    <message>
        <source>tracker</source>
        <translation>跟踪器</translation>
    </message>
    <message>
        <source>Look at address and port, and at what runs there</source>
        <translation>请检查地址和端口，以及那里运行的是什么程序</translation>
    </message>
    <message>
        <source>a message of %1 bytes was announced</source>
        <translation>对方声明的消息长达 %1 字节</translation>
    </message>
    <message>
        <source>nobody can be waited for at this address and port: %1</source>
        <translation>无法在此地址和端口等待连接：%1</translation>
    </message>
    <message>
        <source>address or port is missing</source>
        <translation>缺少地址或端口</translation>
    </message>
    <message>
        <source>Enter both; %1 is the usual port</source>
        <translation>请两项都填写；通常的端口是 %1</translation>
    </message>
    <message>
        <source>this is no address of this computer: 127.0.0.1 is, and 0.0.0.0 are all of them</source>
        <translation>这不是本机的地址：127.0.0.1 是本机，0.0.0.0 表示本机的所有地址</translation>
    </message>
    <message>
        <source>Give another one</source>
        <translation>请换一个</translation>
    </message>
    <message>
        <source>nobody answers at this address and port</source>
        <translation>此地址和端口没有应答</translation>
    </message>
    <message>
        <source>there is no computer of this name</source>
        <translation>没有此名称的计算机</translation>
    </message>
    <message>
        <source>nobody answered in time</source>
        <translation>没有及时得到应答</translation>
    </message>
    <message>
        <source>the tracker ended the connection</source>
        <translation>跟踪器断开了连接</translation>
    </message>
    <message>
        <source>the tracker says: %1</source>
        <translation>跟踪器报告：%1</translation>
    </message>
    <message>
        <source>nothing has come for half a minute</source>
        <translation>半分钟内没有收到任何数据</translation>
    </message>
    <message>
        <source>the instrument was seen for %1 % of the time only</source>
        <translation>器械只有 %1% 的时间被看到</translation>
    </message>
    <message>
        <source>By all runs</source>
        <translation>按全部运行</translation>
    </message>
    <message>
        <source>%1 {mark was|marks were} signed with the password of their rater, %2 {was|were} not.</source>
        <translation>%1 个评分由评分者用密码签名，%2 个没有。</translation>
    </message>
    <message>
        <source>as normal residuals</source>
        <translation>正态残差所在的线</translation>
    </message>
    <message>
        <source>Normal residuals lie along the line. Shapiro and Wilk: W = %1, %2; for looking at, not for choosing a test.</source>
        <translation>正态残差落在这条线上。Shapiro-Wilk：W = %1，%2；仅供查看，不用于选择检验。</translation>
    </message>
    <message>
        <source>Normal residuals lie along the line.</source>
        <translation>正态残差落在这条线上。</translation>
    </message>
    <message>
        <source>too many failures: wait %1</source>
        <translation>失败次数过多：请等待 %1</translation>
    </message>
    <message>
        <source>Amend…</source>
        <translation>更正…</translation>
    </message>
    <message>
        <source>Being read…</source>
        <translation>正在读取……</translation>
    </message>
    <message>
        <source>Move with a reason…</source>
        <translation>说明理由并调整…</translation>
    </message>
    <message>
        <source>Nobody here? The screen will be locked in %1. Press any key to stay</source>
        <translation>没有人在吗？%1 后将锁定屏幕。按任意键继续</translation>
    </message>
    <message>
        <source>Please wait %1, then try again.</source>
        <translation>请等待 %1 后重试。</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>正在保存…</translation>
    </message>
    <message>
        <source>Too many wrong tries. Please wait %1</source>
        <translation>错误次数过多，请等待 %1</translation>
    </message>
    <message>
        <source>side branch</source>
        <translation>旁支</translation>
    </message>
    <message>
        <source>Move its root to where the branch leaves the organ, or turn the direction of the cut.</source>
        <translation>请将旁支根部移到其离开器官之处，或调整切面方向。</translation>
    </message>
    <message>
        <source>nothing of the organ lies beyond the cut of its side branch</source>
        <translation>旁支切面以外没有器官的任何部分</translation>
    </message>
    <message>
        <source>the side branch is more than a tenth of the organ</source>
        <translation>旁支超过器官的十分之一</translation>
    </message>
    <message>
        <source>the place or the direction of the side branch is not finite</source>
        <translation>旁支的位置或方向不是有限数值</translation>
    </message>
    <message>
        <source>the cut of the side branch is no simple loop</source>
        <translation>旁支的切口不是单一闭合环</translation>
    </message>
    <message>
        <source>angle of His</source>
        <translation>His 角（贲门切迹）</translation>
    </message>
    <message>
        <source>antrum, back</source>
        <translation>胃窦后壁</translation>
    </message>
    <message>
        <source>antrum, front</source>
        <translation>胃窦前壁</translation>
    </message>
    <message>
        <source>antrum, greater curvature</source>
        <translation>胃窦大弯</translation>
    </message>
    <message>
        <source>body, back</source>
        <translation>胃体后壁</translation>
    </message>
    <message>
        <source>body, front</source>
        <translation>胃体前壁</translation>
    </message>
    <message>
        <source>body, greater curvature</source>
        <translation>胃体大弯</translation>
    </message>
    <message>
        <source>body, lesser curvature</source>
        <translation>胃体小弯</translation>
    </message>
    <message>
        <source>cardia, front</source>
        <translation>贲门前壁</translation>
    </message>
    <message>
        <source>fundus, back</source>
        <translation>胃底后壁</translation>
    </message>
    <message>
        <source>fundus, front</source>
        <translation>胃底前壁</translation>
    </message>
    <message>
        <source>fundus, greater curvature</source>
        <translation>胃底大弯</translation>
    </message>
    <message>
        <source>incisura angularis</source>
        <translation>角切迹</translation>
    </message>
    <message>
        <source>pylorus, front</source>
        <translation>幽门前壁</translation>
    </message>
    <message>
        <source>nobody asks for this invitation any more</source>
        <translation>已没有人申请此登录邀请</translation>
    </message>
    <message>
        <source>Invitation to Torsio at %1</source>
        <translation>%1 的 Torsio 登录邀请</translation>
    </message>
    <message>
        <source>You are asked to work with Torsio at %1, in the browser of any computer. Open this link and choose a password:
%2
Your sign-in name is %3. The link is good once, until %4, and for you alone: please do not pass it on.</source>
        <translation>邀请您在 %1 使用 Torsio，任何电脑的浏览器均可。请打开此链接并设置密码：
%2
您的登录名是 %3。链接仅供您本人使用一次，有效期至 %4：请勿转发。</translation>
    </message>
    <message>
        <source>The code that goes with your invitation to Torsio at %1 is %2. The link comes by another way.</source>
        <translation>您在 %1 使用 Torsio 的登录邀请代码是 %2。链接通过其他途径送达。</translation>
    </message>
    <message>
        <source>no mail address is known</source>
        <translation>没有邮件地址</translation>
    </message>
    <message>
        <source>%1 was recording at %2, which does not answer since %3. Go and look.</source>
        <translation>%1 正在 %2 记录，该工作站自 %3 起无响应。请前往查看。</translation>
    </message>
    <message>
        <source>%1 does not answer since %2.</source>
        <translation>%1 自 %2 起无响应。</translation>
    </message>
    <message>
        <source>%1: the device is not fit for graded runs: %2.</source>
        <translation>%1：设备不可用于计分操作：%2。</translation>
    </message>
    <message>
        <source>%1, last run: %2. %3.</source>
        <translation>%1，上次操作：%2。%3。</translation>
    </message>
    <message>
        <source>%1 was expected at %2, %3, and has not begun.</source>
        <translation>%1 应于 %2 在 %3 开始，但尚未开始。</translation>
    </message>
    <message>
        <source>%1 has rested longer than allowed.</source>
        <translation>%1 的休息超过规定时间。</translation>
    </message>
    <message>
        <source>%1: sheets still missing: %2.</source>
        <translation>%1：仍缺评分表：%2。</translation>
    </message>
    <message>
        <source>Trainees without a group: %1. Draw them under Allocation.</source>
        <translation>未分组的学员：%1。请在“随机分组”中抽取。</translation>
    </message>
    <message>
        <source>Twists on target</source>
        <translation>达标扭转</translation>
    </message>
    <message>
        <source>Targets reached</source>
        <translation>达到目标次数</translation>
    </message>
    <message>
        <source>Time of a twist</source>
        <translation>单次扭转时间</translation>
    </message>
    <message>
        <source>Time to target</source>
        <translation>到达目标时间</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>稳定时间</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>超调</translation>
    </message>
    <message>
        <source>Steadiness of the hold</source>
        <translation>保持稳定度</translation>
    </message>
    <message>
        <source>Smoothness</source>
        <translation>平滑度</translation>
    </message>
    <message>
        <source>Smoothness (jerk)</source>
        <translation>平滑度（急动度）</translation>
    </message>
    <message>
        <source>Economy of turning</source>
        <translation>转动经济性</translation>
    </message>
    <message>
        <source>Sub-movements</source>
        <translation>子动作数</translation>
    </message>
    <message>
        <source>Angular path</source>
        <translation>角路径</translation>
    </message>
    <message>
        <source>Tracking error</source>
        <translation>跟踪误差</translation>
    </message>
    <message>
        <source>Excursions</source>
        <translation>越界次数</translation>
    </message>
    <message>
        <source>Path of the tip</source>
        <translation>尖端路径</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>最大力</translation>
    </message>
    <message>
        <source>Mean force</source>
        <translation>平均力</translation>
    </message>
    <message>
        <source>Force violations</source>
        <translation>超力次数</translation>
    </message>
    <message>
        <source>Abruptness of release</source>
        <translation>松开的突然程度</translation>
    </message>
    <message>
        <source>Time until blood flows</source>
        <translation>恢复血流的时间</translation>
    </message>
    <message>
        <source>Ischaemic dose</source>
        <translation>缺血剂量</translation>
    </message>
    <message>
        <source>Ischaemic dose when blood flows</source>
        <translation>恢复血流时的缺血剂量</translation>
    </message>
    <message>
        <source>Twist that remains</source>
        <translation>残余扭转</translation>
    </message>
    <message>
        <source>Relapse</source>
        <translation>复发</translation>
    </message>
    <message>
        <source>Turned the wrong way</source>
        <translation>反向转动</translation>
    </message>
    <message>
        <source>Re-grips</source>
        <translation>重新夹持次数</translation>
    </message>
    <message>
        <source>Least number of re-grips</source>
        <translation>最少重新夹持次数</translation>
    </message>
    <message>
        <source>Slipped back</source>
        <translation>回滑</translation>
    </message>
    <message>
        <source>Peak pressure of the jaw</source>
        <translation>钳口压强峰值</translation>
    </message>
    <message>
        <source>Peak shear of the wall</source>
        <translation>壁的剪应力峰值</translation>
    </message>
    <message>
        <source>Time of overload</source>
        <translation>超负荷时间</translation>
    </message>
    <message>
        <source>Least patency</source>
        <translation>最小通畅度</translation>
    </message>
    <message>
        <source>Let out first</source>
        <translation>先行减压</translation>
    </message>
    <message>
        <source>Longest turn without a rest</source>
        <translation>未停歇的最大复位转角</translation>
    </message>
    <message>
        <source>Undone in stages</source>
        <translation>分阶段复位</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Undone, open and supplied with hands off: not measured</source>
        <translation>松手后已复位、通畅且有血供：未测量</translation>
    </message>
    <message>
        <source>Undone, open and supplied with hands off: yes</source>
        <translation>松手后已复位、通畅且有血供：是</translation>
    </message>
    <message>
        <source>Undone, open and supplied with hands off: no</source>
        <translation>松手后已复位、通畅且有血供：否</translation>
    </message>
    <message>
        <source>Twists completed: %1, at least %2 wanted</source>
        <translation>已完成扭转：%1 次，要求至少 %2 次</translation>
    </message>
    <message>
        <source>Twists completed: %1 of %2</source>
        <translation>已完成的扭转：%1 / %2</translation>
    </message>
    <message>
        <source>Twists released on target: %1 of %2, wanted %3</source>
        <translation>达标释放：%1 / %2，要求 %3</translation>
    </message>
    <message>
        <source>Shortest hold on target: %1 s, wanted %2 s</source>
        <translation>目标处最短保持：%1 秒，要求 %2 秒</translation>
    </message>
    <message>
        <source>Hold on target: none, wanted %1 s</source>
        <translation>目标处保持：无，要求 %1 秒</translation>
    </message>
    <message>
        <source>Peak force on the tissue: %1 N, limit %2 N</source>
        <translation>组织所受最大力：%1 N，限值 %2 N</translation>
    </message>
    <message>
        <source>Peak force: not measured, limit %1 N</source>
        <translation>最大力：未测得，限值 %1 N</translation>
    </message>
    <message>
        <source>Peak torque: %1 N m, limit %2 N m</source>
        <translation>最大扭矩：%1 N m，限值 %2 N m</translation>
    </message>
    <message>
        <source>Peak torque: not measured, limit %1 N m</source>
        <translation>最大扭矩：未测得，限值 %1 N m</translation>
    </message>
    <message>
        <source>%1: %2, wanted %3</source>
        <translation>%1：%2，要求 %3</translation>
    </message>
    <message>
        <source>%1: %2, at least %3</source>
        <translation>%1：%2，至少 %3</translation>
    </message>
    <message>
        <source>%1: %2, at most %3</source>
        <translation>%1：%2，至多 %3</translation>
    </message>
    <message>
        <source>%1 (%2 in a row, %3 needed)</source>
        <translation>%1（已连续 %2 次，需要 %3 次）</translation>
    </message>
    <message>
        <source>Peak force of one twist</source>
        <translation>单次扭转的最大力</translation>
    </message>
    <message>
        <source>%1: %2, better than the expert (%3)</source>
        <translation>%1：%2，优于专家（%3）</translation>
    </message>
    <message>
        <source>%1: %2, as good as the expert (%3)</source>
        <translation>%1：%2，与专家相当（%3）</translation>
    </message>
    <message>
        <source>%1: %2, close to the expert (%3)</source>
        <translation>%1：%2，接近专家（%3）</translation>
    </message>
    <message>
        <source>%1: %2, the expert had %3</source>
        <translation>%1：%2，专家为 %3</translation>
    </message>
    <message>
        <source>Turn in one decided movement instead of feeling your way.</source>
        <translation>果断地一次转动，不要边试边转。</translation>
    </message>
    <message>
        <source>Slow down before the target, then stay.</source>
        <translation>到目标前放慢，然后停住。</translation>
    </message>
    <message>
        <source>Begin to slow down ten degrees before the target.</source>
        <translation>在目标前十度开始放慢。</translation>
    </message>
    <message>
        <source>Rest your forearm while you hold.</source>
        <translation>保持时让前臂有支撑。</translation>
    </message>
    <message>
        <source>Let speed rise and fall once, without stops.</source>
        <translation>速度一次上升、一次下降，中途不停。</translation>
    </message>
    <message>
        <source>Avoid turning back and forth.</source>
        <translation>避免来回转动。</translation>
    </message>
    <message>
        <source>One push instead of many small ones.</source>
        <translation>一次发力，不要多次小动作。</translation>
    </message>
    <message>
        <source>Press less while you turn; the grip holds the tissue.</source>
        <translation>转动时少用压力，夹持已固定组织。</translation>
    </message>
    <message>
        <source>Turn back a little before you open the jaw.</source>
        <translation>张开钳口前先稍微转回。</translation>
    </message>
    <message>
        <source>%1, asked for by %2: %3</source>
        <translation>%1，由 %2 申请：%3</translation>
    </message>
    <message>
        <source>A link of their own, with which people set a password in a browser. It is good once and for a week; a link made before is of no use then.</source>
        <translation>个人专用链接，用于在浏览器中设置密码。链接一周内可用一次；此前生成的链接随即作废。</translation>
    </message>
    <message>
        <source>Another administrator asks for these invitations and has handed over a code for each. Whoever confirms one hands over the link.</source>
        <translation>另一位管理员申请了这些邀请，并已逐一转交代码。由确认者转交链接。</translation>
    </message>
    <message>
        <source>Chosen: %1</source>
        <translation>已选：%1</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>代码</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>Confirm the invitation of %1</source>
        <translation>确认 %1 的登录邀请</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>已复制</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Each is for one person. A code goes to its person by another way than the link that another administrator hands over.</source>
        <translation>每张仅供一人。代码与另一位管理员转交的链接应经不同途径送达本人。</translation>
    </message>
    <message>
        <source>Film strip</source>
        <translation>关键画面</translation>
    </message>
    <message>
        <source>Good once, until</source>
        <translation>仅可使用一次，有效期至</translation>
    </message>
    <message>
        <source>Invitations</source>
        <translation>登录邀请</translation>
    </message>
    <message>
        <source>Invite</source>
        <translation>邀请登录</translation>
    </message>
    <message>
        <source>Invited until</source>
        <translation>邀请有效期</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>链接</translation>
    </message>
    <message>
        <source>Moment %1</source>
        <translation>时刻 %1</translation>
    </message>
    <message>
        <source>Not sent: %1</source>
        <translation>未发送：%1</translation>
    </message>
    <message>
        <source>Password of the mail server</source>
        <translation>邮件服务器密码</translation>
    </message>
    <message>
        <source>Print the cards</source>
        <translation>打印卡片</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>Send the links by mail, too</source>
        <translation>同时以邮件发送链接</translation>
    </message>
    <message>
        <source>Sent by mail</source>
        <translation>已以邮件发送</translation>
    </message>
    <message>
        <source>Shown only now</source>
        <translation>仅此次显示</translation>
    </message>
    <message>
        <source>somebody else must confirm this</source>
        <translation>须由他人确认</translation>
    </message>
    <message>
        <source>Take the links back</source>
        <translation>收回链接</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>The links are of no use any more</source>
        <translation>链接已作废</translation>
    </message>
    <message>
        <source>This browser draws nothing in three dimensions (no WebGL 2): a film strip shows some moments; the traces are complete.</source>
        <translation>此浏览器不能绘制三维画面（无 WebGL 2）：以关键画面显示若干时刻；曲线完整。</translation>
    </message>
    <message>
        <source>This needs two people: you get a code for each to hand over, and another administrator, who confirms it, the link.</source>
        <translation>此操作需要两人：您得到每人的代码并转交，另一位管理员确认后得到链接。</translation>
    </message>
    <message>
        <source>To be confirmed</source>
        <translation>待确认</translation>
    </message>
    <message>
        <source>What needs attention</source>
        <translation>需要注意的事项</translation>
    </message>
    <message>
        <source>What to work on</source>
        <translation>需要改进的地方</translation>
    </message>
    <message>
        <source>What went well</source>
        <translation>做得好的地方</translation>
    </message>
    <message>
        <source>Words for a mail</source>
        <translation>邮件正文</translation>
    </message>
    <message>
        <source>Skills lab (demonstration)</source>
        <translation>技能实验室（演示）</translation>
    </message>
    <message>
        <source>Paper protocol: three arms (demonstration)</source>
        <translation>论文方案：三组（演示）</translation>
    </message>
    <message>
        <source>Volvulus and torsion: undo it (demonstration)</source>
        <translation>肠胃扭转与睾丸扭转：复位（演示）</translation>
    </message>
    <message>
        <source>Twist on the arm (demonstration)</source>
        <translation>手臂上的扭转（演示）</translation>
    </message>
    <message>
        <source>Overall mark on the real arm (demonstration)</source>
        <translation>实物手臂总分（演示）</translation>
    </message>
    <message>
        <source>proposed model (Kriging + membrane)</source>
        <translation>所提模型（Kriging + 膜）</translation>
    </message>
    <message>
        <source>finite elements</source>
        <translation>有限元</translation>
    </message>
    <message>
        <source>mass-spring</source>
        <translation>质点弹簧</translation>
    </message>
    <message>
        <source>Left out: level of %1 people, sex of %2, free text of %3 entries, person of %4 deviations.</source>
        <translation>已略去：%1 人的培训阶段、%2 人的性别、%3 条自由文本、%4 条方案偏离所涉人员。</translation>
    </message>
    <message>
        <source>Mesentero-axial, 40 degrees</source>
        <translation>系膜轴型 40 度</translation>
    </message>
    <message>
        <source>Stomach: mesentero-axial, 40 degrees</source>
        <translation>胃：系膜轴型 40 度</translation>
    </message>
    <message>
        <source>has signed in</source>
        <translation>已登录过</translation>
    </message>
    <message>
        <source>is enrolled in a cohort</source>
        <translation>已在批次中登记</translation>
    </message>
    <message>
        <source>has decided about a consent</source>
        <translation>已对知情同意作出决定</translation>
    </message>
    <message>
        <source>is asked for sheets</source>
        <translation>已被要求填写评分表</translation>
    </message>
    <message>
        <source>is asked for an evaluation of models</source>
        <translation>已被邀请参加模型评价</translation>
    </message>
    <message>
        <source>has asked for something about the record</source>
        <translation>已就其记录提出请求</translation>
    </message>
    <message>
        <source>has something in the record already</source>
        <translation>在记录中已有内容</translation>
    </message>
    <message>
        <source>%1 was changed since</source>
        <translation>%1 此后被修改过</translation>
    </message>
    <message>
        <source>nobody of it is left</source>
        <translation>其中已无人留存</translation>
    </message>
    <message>
        <source>the reason is missing</source>
        <translation>缺少原因</translation>
    </message>
    <message>
        <source>Nothing was taken back. Set who should not be here to &quot;left&quot;, or erase them one by one</source>
        <translation>未撤回任何内容。请将不应在此的人员设为“已离开”，或逐个删除</translation>
    </message>
    <message>
        <source>this import was taken back already, or there is no such import</source>
        <translation>该导入已被撤回，或不存在该导入</translation>
    </message>
    <message>
        <source>the account has no sign-in name</source>
        <translation>该账户没有登录名</translation>
    </message>
    <message>
        <source>the sign-in name %1</source>
        <translation>登录名%1</translation>
    </message>
    <message>
        <source>the sign-in name %1 looks like %2, but is another</source>
        <translation>登录名 %1 与 %2 外观相似，却是另一个</translation>
    </message>
    <message>
        <source>Choose one that nobody takes for the other</source>
        <translation>请另选一个不会混淆的登录名</translation>
    </message>
    <message>
        <source>another program uses this port</source>
        <translation>该端口已被其他程序占用</translation>
    </message>
    <message>
        <source>Choose another one, or close that program</source>
        <translation>请换一个端口，或关闭该程序</translation>
    </message>
    <message>
        <source>the review desk did not open</source>
        <translation>评分台未能开放</translation>
    </message>
    <message>
        <source>Look at what it said last, mend that, and try again</source>
        <translation>请查看其最后的提示，排除问题后重试</translation>
    </message>
    <message>
        <source>this record lies on a server</source>
        <translation>该记录库位于服务器上</translation>
    </message>
    <message>
        <source>Whoever runs the server opens the review desk there, by torsio serve</source>
        <translation>由服务器管理者在服务器上用 torsio serve 开放评分台</translation>
    </message>
    <message>
        <source>the review desk is open already</source>
        <translation>评分台已经开放</translation>
    </message>
    <message>
        <source>Close it first</source>
        <translation>请先关闭</translation>
    </message>
    <message>
        <source>certificate and key belong together</source>
        <translation>证书与密钥须成对使用</translation>
    </message>
    <message>
        <source>Choose both files</source>
        <translation>请同时选择两个文件</translation>
    </message>
    <message>
        <source>the password is made of words that are tried first</source>
        <translation>密码由最先被尝试的常见词组成</translation>
    </message>
</context>
<context>
    <name>UserDialogs</name>
    <message>
        <source>May work as</source>
        <translation>可担任的角色</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>学员</translation>
    </message>
    <message>
        <source>Physician who scores</source>
        <translation>评分医师</translation>
    </message>
    <message>
        <source>Administrator</source>
        <translation>管理员</translation>
    </message>
    <message>
        <source>Allocator</source>
        <translation>分组管理员</translation>
    </message>
    <message>
        <source>Statistician</source>
        <translation>统计师</translation>
    </message>
    <message>
        <source>New user</source>
        <translation>新建用户</translation>
    </message>
    <message>
        <source>Add user</source>
        <translation>添加用户</translation>
    </message>
    <message>
        <source>Nobody of the record</source>
        <translation>不对应任何在册人员</translation>
    </message>
    <message>
        <source>&amp;Sign-in name</source>
        <translation>登录名(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Person</source>
        <translation>人员(&amp;P)</translation>
    </message>
    <message>
        <source>Trainees and physicians need a person of the record. The start password is shown once, and must be changed at the first sign-in.</source>
        <translation>学员和医师必须对应在册人员。初始密码只显示一次，首次登录时必须修改。</translation>
    </message>
    <message>
        <source>Roles of %1</source>
        <translation>%1 的角色</translation>
    </message>
    <message>
        <source>Change roles</source>
        <translation>修改角色</translation>
    </message>
    <message>
        <source>&amp;Reason</source>
        <translation>原因(&amp;R)</translation>
    </message>
    <message>
        <source>Enter the name to sign in with.</source>
        <translation>请输入登录名。</translation>
    </message>
    <message>
        <source>Choose a person: whoever trains or scores is one of the record.</source>
        <translation>请选择人员：训练或评分的人必须在记录中。</translation>
    </message>
    <message>
        <source>Choose at least one role.</source>
        <translation>请至少选择一个角色。</translation>
    </message>
    <message>
        <source>These are the present roles.</source>
        <translation>与当前角色相同。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::AccountsDialog</name>
    <message>
        <source>Start passwords</source>
        <translation>初始密码</translation>
    </message>
    <message>
        <source>These start passwords are shown only now. Hand each to its person, on a card in a closed envelope for example. At the first sign-in everybody chooses a password of their own.</source>
        <translation>这些初始密码只在此时显示。请分别交给本人，例如用装在信封里的卡片。首次登录时每人设置自己的密码。</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>人员</translation>
    </message>
    <message>
        <source>Sign-in name</source>
        <translation>登录名</translation>
    </message>
    <message>
        <source>Start password</source>
        <translation>初始密码</translation>
    </message>
    <message>
        <source>start-passwords.pdf</source>
        <translation>初始密码.pdf</translation>
    </message>
</context>
<context>
    <name>torsio::gui::AllocationPage</name>
    <message>
        <source>No design is locked yet. Preview the balance, then lock: the seed is drawn and sealed at that moment.</source>
        <translation>尚未锁定分组方案。请先预览均衡程度再锁定：种子在锁定时抽取并封存。</translation>
    </message>
    <message>
        <source>Locked %1 · %2 allocated, %3 moved by hand
%4
Commitment: %5
Seed: %6</source>
        <translation>锁定于 %1 · 已分组 %2 人，人工调整 %3 人
%4
承诺值：%5
种子：%6</translation>
    </message>
    <message>
        <source>sealed</source>
        <translation>已封存</translation>
    </message>
    <message>
        <source>as drawn</source>
        <translation>按抽取结果</translation>
    </message>
    <message>
        <source>There is no cohort yet. Make one under Cohorts and enrol its trainees.</source>
        <translation>尚无批次。请在“批次”中新建并登记学员。</translation>
    </message>
    <message>
        <source>%1

Only an allocator previews, locks and draws. An administrator gives this role to somebody under Users.</source>
        <translation>%1

只有分组管理员可以预览、锁定和抽取。管理员可在“用户”中授予此角色。</translation>
    </message>
    <message>
        <source>The design is locked and its seed is sealed</source>
        <translation>方案已锁定，种子已封存</translation>
    </message>
    <message>
        <source>Replace the design</source>
        <translation>更换方案</translation>
    </message>
    <message>
        <source>Trainees were already allocated by the present design; they stay where they are.</source>
        <translation>已有学员按现行方案分组；他们保持原组。</translation>
    </message>
    <message>
        <source>Lock the design</source>
        <translation>锁定方案</translation>
    </message>
    <message>
        <source>After locking, the design cannot be changed without a trace. Lock it?</source>
        <translation>锁定后，任何更改都会留下记录。确定锁定吗？</translation>
    </message>
    <message numerus="yes">
        <source>%n trainee(s) allocated</source>
        <translation>
            <numerusform>已分组 %n 名学员</numerusform>
        </translation>
    </message>
    <message>
        <source>Open the seal</source>
        <translation>启封种子</translation>
    </message>
    <message>
        <source>From now on anybody can repeat the draw, and foresee what is left of it.</source>
        <translation>此后任何人都可以重复抽取，也能预知剩余的抽取结果。</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>Sealed cards</source>
        <translation>密封卡片</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Check of the draw</source>
        <translation>核对抽取</translation>
    </message>
    <message>
        <source>The draw does not fit its record: %1</source>
        <translation>抽取与记录不符：%1</translation>
    </message>
    <message>
        <source>Allocation</source>
        <translation>随机分组</translation>
    </message>
    <message>
        <source>Random groups that anybody can check afterwards: design, lock, draw, proof.</source>
        <translation>任何人事后都可核对的随机分组：设计、锁定、抽取、验证。</translation>
    </message>
    <message>
        <source>&amp;Cohort</source>
        <translation>批次(&amp;C)</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>方案</translation>
    </message>
    <message>
        <source>&amp;Method</source>
        <translation>方法(&amp;M)</translation>
    </message>
    <message>
        <source>Balanced by</source>
        <translation>均衡因素</translation>
    </message>
    <message>
        <source>&amp;Block sizes</source>
        <translation>区组大小(&amp;B)</translation>
    </message>
    <message>
        <source>Multiples of the number of groups; several are mixed at random</source>
        <translation>组数的倍数；可填多个，随机混用</translation>
    </message>
    <message>
        <source>&amp;Preview balance</source>
        <translation>预览均衡(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Lock design…</source>
        <translation>锁定方案(&amp;L)…</translation>
    </message>
    <message>
        <source>&amp;Allocate everybody</source>
        <translation>全部分组(&amp;A)</translation>
    </message>
    <message>
        <source>Ca&amp;rds…</source>
        <translation>卡片(&amp;R)…</translation>
    </message>
    <message>
        <source>A page with a label and a card for each envelope, to print</source>
        <translation>供打印的页面：每个信封一张标签和一张卡片</translation>
    </message>
    <message>
        <source>&amp;Open the seal…</source>
        <translation>启封种子(&amp;O)…</translation>
    </message>
    <message>
        <source>Chec&amp;k the draw</source>
        <translation>核对抽取(&amp;K)</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>取值</translation>
    </message>
    <message>
        <source>Trainees</source>
        <translation>学员</translation>
    </message>
    <message>
        <source>Usual difference</source>
        <translation>平均差</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>最大差</translation>
    </message>
    <message>
        <source>Preview the balance to see how even the groups would be.</source>
        <translation>预览后可看到各组的均衡程度。</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>序号</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>学员</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>组别</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>How</source>
        <translation>方式</translation>
    </message>
    <message>
        <source>Hash</source>
        <translation>哈希</translation>
    </message>
    <message>
        <source>Nobody is allocated yet.</source>
        <translation>尚无人分组。</translation>
    </message>
    <message>
        <source>Mo&amp;ve by hand…</source>
        <translation>手动调整(&amp;V)…</translation>
    </message>
    <message>
        <source>Puts a trainee into another group than the draw did, with a reason</source>
        <translation>将学员调整到与抽取结果不同的组，并注明原因</translation>
    </message>
    <message>
        <source>Moved by hand; the drawn record stays beside it</source>
        <translation>已手动调整；抽取记录仍予保留</translation>
    </message>
    <message>
        <source>%1 (salt %2)</source>
        <translation>%1（盐值 %2）</translation>
    </message>
    <message>
        <source>Balance preview</source>
        <translation>均衡预览</translation>
    </message>
    <message>
        <source>Balance preview, over %1 draws with other seeds</source>
        <translation>均衡预览：以其他种子试抽 %1 次</translation>
    </message>
    <message numerus="yes">
        <source>%n trainee(s) lack one of these details: %1</source>
        <translation>
            <numerusform>%n 名学员缺少其中某项资料：%1</numerusform>
        </translation>
    </message>
    <message>
        <source>The whole draw was repeated: every record is as drawn (%1), moved by hand: %2.</source>
        <translation>已重复全部抽取：%1 条记录均与抽取一致，其中 %2 条经人工调整。</translation>
    </message>
    <message>
        <source>Current design</source>
        <translation>现行方案</translation>
    </message>
    <message>
        <source>Allocations</source>
        <translation>分组记录</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>各组预期人数</translation>
    </message>
</context>
<context>
    <name>torsio::gui::AngleDial</name>
    <message>
        <source>Twist angle</source>
        <translation>扭转角</translation>
    </message>
    <message>
        <source>on target</source>
        <translation>已达目标</translation>
    </message>
    <message>
        <source>target %1</source>
        <translation>目标 %1</translation>
    </message>
    <message>
        <source>%1°, target %2°</source>
        <translation>%1°，目标 %2°</translation>
    </message>
</context>
<context>
    <name>torsio::gui::AskCard</name>
    <message>
        <source>As&amp;k about %1</source>
        <translation>就 %1 提问(&amp;K)</translation>
    </message>
    <message>
        <source>Sent to %1: %2</source>
        <translation>已发送给 %1：%2</translation>
    </message>
    <message>
        <source>%1  ·  %2 answered on %3</source>
        <translation>%1  ·  %2 于 %3 回答</translation>
    </message>
    <message>
        <source>%1  ·  with %2, waiting for %3</source>
        <translation>%1  ·  由 %2 处理，已等待 %3</translation>
    </message>
    <message>
        <source>You: %1</source>
        <translation>您：%1</translation>
    </message>
    <message>
        <source>Ask a physician about this moment</source>
        <translation>就这一时刻向医师提问</translation>
    </message>
    <message>
        <source>Physician</source>
        <translation>医师</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>What do you want to know?</source>
        <translation>您想了解什么？</translation>
    </message>
    <message>
        <source>T&amp;o</source>
        <translation>收件人(&amp;O)</translation>
    </message>
    <message>
        <source>%1  ·  %2 answered on %3, edited since</source>
        <translation>%1  ·  %2 于 %3 答复，之后修改过</translation>
    </message>
</context>
<context>
    <name>torsio::gui::AuditPage</name>
    <message>
        <source>Audit trail</source>
        <translation>审计记录</translation>
    </message>
    <message>
        <source>Who did what, when, where and why. Entries are chained: none can be changed or taken out without being found.</source>
        <translation>何人在何时、何地、因何做了何事。条目相互链接，任何修改或删除都会被发现。</translation>
    </message>
    <message>
        <source>&amp;Verify</source>
        <translation>验证(&amp;V)</translation>
    </message>
    <message>
        <source>Last day</source>
        <translation>最近一天</translation>
    </message>
    <message>
        <source>Last week</source>
        <translation>最近一周</translation>
    </message>
    <message>
        <source>Last month</source>
        <translation>最近一个月</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Only the newest entries of this time are shown; this shows twice as many</source>
        <translation>目前只显示该时间段内最新的条目；点击后显示两倍的条目</translation>
    </message>
    <message>
        <source>Time span</source>
        <translation>时间范围</translation>
    </message>
    <message>
        <source>Chosen entry</source>
        <translation>所选条目</translation>
    </message>
    <message>
        <source>Choose an entry to see what was changed.</source>
        <translation>选择一个条目以查看更改内容。</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>序号</translation>
    </message>
    <message>
        <source>When</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>人员</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>工作站</translation>
    </message>
    <message>
        <source>What</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Nothing happened in this time.</source>
        <translation>此时间段内没有记录。</translation>
    </message>
    <message>
        <source>When (UTC)</source>
        <translation>时间 (UTC)</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>更改前</translation>
    </message>
    <message>
        <source>After</source>
        <translation>更改后</translation>
    </message>
    <message>
        <source>Seal</source>
        <translation>封印</translation>
    </message>
    <message>
        <source>Verifying the audit trail</source>
        <translation>正在验证审计记录</translation>
    </message>
    <message numerus="yes">
        <source>⚠ %n finding(s). Do not report from this record before they are explained.</source>
        <translation>
            <numerusform>⚠ 发现 %n 处问题。查明原因之前请勿据此记录出具报告。</numerusform>
        </translation>
    </message>
    <message>
        <source>Code</source>
        <translation>代码</translation>
    </message>
    <message>
        <source>Show &amp;more of %1</source>
        <translation>显示更多（共 %1 条）(&amp;M)</translation>
    </message>
    <message>
        <source>Between two days</source>
        <translation>两个日期之间</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>至</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>All entries of this time as a table (CSV)</source>
        <translation>将此时段的全部条目导出为表格（CSV）</translation>
    </message>
    <message numerus="yes">
        <source>%n entries saved</source>
        <translation>
            <numerusform>已保存 %n 条</numerusform>
        </translation>
    </message>
    <message>
        <source>Export the audit trail</source>
        <translation>导出审计记录</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Checks every entry, every sealed mark and every recorded run</source>
        <translation>检查每个条目、每个已封存的评分和每次已录制的操作</translation>
    </message>
    <message>
        <source>✓ Everything is as it was written: entries, marks and runs.</source>
        <translation>✓ 条目、评分和操作均与写入时一致。</translation>
    </message>
    <message>
        <source>&amp;Heads…</source>
        <translation>链头(&amp;H)…</translation>
    </message>
    <message>
        <source>The key of this station, its witness file, and what kept heads say</source>
        <translation>本站的密钥、见证文件，以及已保存链头的核对结果</translation>
    </message>
</context>
<context>
    <name>torsio::gui::BriefingPage</name>
    <message>
        <source>Graded run: it counts as an attempt.</source>
        <translation>计分操作：计入一次尝试。</translation>
    </message>
    <message>
        <source>Practice: nothing is graded.</source>
        <translation>练习：不计分。</translation>
    </message>
    <message>
        <source>What is asked for</source>
        <translation>任务要求</translation>
    </message>
    <message>
        <source>How to do it</source>
        <translation>操作方法</translation>
    </message>
    <message>
        <source>Twist to %1° and let go within %2°.</source>
        <translation>扭转至 %1°，松开时误差不超过 %2°。</translation>
    </message>
    <message>
        <source>Hold for %1 s before you let go.</source>
        <translation>松开前保持 %1 秒。</translation>
    </message>
    <message>
        <source>Keep the force below %1 N.</source>
        <translation>力保持在 %1 N 以下。</translation>
    </message>
    <message>
        <source>Keep the torque below %1 N m.</source>
        <translation>扭矩保持在 %1 N m 以下。</translation>
    </message>
    <message>
        <source>Mastered when:
%1</source>
        <translation>达标条件：
%1</translation>
    </message>
    <message>
        <source>Bring the jaw to the marked band, close it, turn in one even movement, hold, and open the jaw gently.
Mouse: left button grips, dragging turns, the wheel moves nearer.</source>
        <translation>将钳口移到标记带，夹紧，一次平稳地转动，保持，然后轻轻张开钳口。
鼠标：左键夹持，拖动转动，滚轮前后移动。</translation>
    </message>
    <message>
        <source>An expert&apos;s run of the same twist</source>
        <translation>专家对同一扭转的操作</translation>
    </message>
    <message>
        <source>&amp;Watch again</source>
        <translation>再看一遍(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Start the graded run</source>
        <translation>开始计分操作(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>开始(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>返回(&amp;B)</translation>
    </message>
    <message>
        <source>The organ came twisted by %1° to %2°. Undo it.</source>
        <translation>器官已扭转 %1° 至 %2°。请复位。</translation>
    </message>
    <message>
        <source>The organ came twisted by %1°. Undo it.</source>
        <translation>器官已扭转 %1°。请复位。</translation>
    </message>
    <message>
        <source>Done: at most %1° left and blood flow of %2 % or more, for %3 s with hands off.</source>
        <translation>完成标准：剩余不超过 %1°，血流不低于 %2 %，并在松手后保持 %3 秒。</translation>
    </message>
    <message>
        <source>The lumen must be open to %1 %.</source>
        <translation>管腔须通畅至 %1 %。</translation>
    </message>
    <message>
        <source>The jaw bruises the wall from %1 kPa; tissue without blood bears less.</source>
        <translation>钳口压力达到 %1 kPa 即挫伤管壁；缺血组织承受力更低。</translation>
    </message>
    <message>
        <source>Meanwhile %1 s of the tissue pass each second.</source>
        <translation>其间每 1 秒相当于组织 %1 秒。</translation>
    </message>
    <message>
        <source>Grip the turned part and turn it back. Before you let go to grip anew set the clip, or it turns back. Let gas out first where it resists.
C: clip. V: gas out. 1, 2, 3: look, feel the pulse, Doppler.
Mouse: left button grips, dragging turns, the wheel moves nearer.</source>
        <translation>抓住扭转的部分并转回。松手重新抓持之前请先上夹子，否则会回转。遇到阻力时先排气。
C：夹子。V：排气。1、2、3：观察、触摸搏动、多普勒。
鼠标：左键抓持，拖动转动，滚轮靠近。</translation>
    </message>
    <message>
        <source>An expert undoes the same organ</source>
        <translation>专家为同一器官复位</translation>
    </message>
    <message>
        <source>When you are held to be able</source>
        <translation>何时被认为胜任</translation>
    </message>
    <message numerus="yes">
        <source>Twist at least %n time(s).</source>
        <translation>
            <numerusform>至少扭转 %n 次。</numerusform>
        </translation>
    </message>
    <message>
        <source>the jaw goes to the marked band.</source>
        <translation>钳口移向标记的环带。</translation>
    </message>
    <message>
        <source>it touches, and the jaw closes.</source>
        <translation>接触组织，钳口夹紧。</translation>
    </message>
    <message>
        <source>it holds the turned part and turns it back.</source>
        <translation>夹住扭转的部分并将其转回。</translation>
    </message>
    <message>
        <source>on target; it holds still before it lets go.</source>
        <translation>已到目标；松开之前保持不动。</translation>
    </message>
    <message>
        <source>one even turn, slower towards the target.</source>
        <translation>一次平稳的转动，接近目标时放慢。</translation>
    </message>
    <message>
        <source>hands off: does it stay undone, does blood flow?</source>
        <translation>松手观察：是否不再回转，血流是否恢复？</translation>
    </message>
    <message>
        <source>the jaw opens gently; the organ turns back by itself.</source>
        <translation>钳口轻轻张开；器官自行回转。</translation>
    </message>
    <message>
        <source>An expert&apos;s run: it is over. Watch again, or start.</source>
        <translation>专家操作已结束。可以再看一遍，或开始操作。</translation>
    </message>
    <message>
        <source>An expert&apos;s run: %1</source>
        <translation>专家操作：%1</translation>
    </message>
    <message>
        <source>S&amp;low motion</source>
        <translation>慢动作(&amp;L)</translation>
    </message>
</context>
<context>
    <name>torsio::gui::CallBar</name>
    <message>
        <source>what is due</source>
        <translation>当前到期的</translation>
    </message>
    <message>
        <source>Say in which room the real arm stands.</source>
        <translation>请填写实物手臂所在的房间。</translation>
    </message>
    <message>
        <source>Call nevertheless</source>
        <translation>仍然呼叫</translation>
    </message>
    <message>
        <source>%1, and &quot;%2&quot; is to be scored. Why now? It is noted as a deviation.</source>
        <translation>%1，而将要评分的是“%2”。为何现在呼叫？这会登记为方案偏离。</translation>
    </message>
    <message>
        <source>case %1 · %2 · %3 · %4</source>
        <translation>案例 %1 · %2 · %3 · %4</translation>
    </message>
    <message>
        <source>! Late: %1</source>
        <translation>! 逾期：%1</translation>
    </message>
    <message>
        <source>● Called: %1</source>
        <translation>● 呼叫中：%1</translation>
    </message>
    <message>
        <source>missing: %1</source>
        <translation>未交：%1</translation>
    </message>
    <message>
        <source>Copy reminder</source>
        <translation>复制提醒</translation>
    </message>
    <message>
        <source>Please submit your sheet of case %1 in Torsio (Live sheet): %2</source>
        <translation>请在 Torsio 的“现场评分表”中提交案例 %1 的评分表：%2</translation>
    </message>
    <message>
        <source>Copied: paste it into a message to these raters.</source>
        <translation>已复制：请粘贴到发给这些评分者的消息中。</translation>
    </message>
    <message>
        <source>Wrong person…</source>
        <translation>叫错人了…</translation>
    </message>
    <message>
        <source>End call</source>
        <translation>结束呼叫</translation>
    </message>
    <message>
        <source>Take the call back</source>
        <translation>撤回呼叫</translation>
    </message>
    <message>
        <source>Somebody else than %1 stood at the arm: the sheets are closed again, what was typed is kept for the next call.</source>
        <translation>站在手臂旁的不是 %1：评分表将重新关闭，已填写的内容保留到下次呼叫。</translation>
    </message>
    <message>
        <source>Call to the real &amp;arm</source>
        <translation>呼叫到实物手臂(&amp;A)</translation>
    </message>
    <message>
        <source>R&amp;oom</source>
        <translation>房间(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;for</source>
        <translation>评分时点(&amp;F)</translation>
    </message>
    <message>
        <source>code or scan</source>
        <translation>输入或扫描编号</translation>
    </message>
    <message>
        <source>Call</source>
        <translation>呼叫</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n sheet(s) in</source>
        <translation>
            <numerusform>已收到 %1 / %n 份评分表</numerusform>
        </translation>
    </message>
    <message>
        <source>Show one</source>
        <translation>只显示一行</translation>
    </message>
    <message>
        <source>Show all (%1, late: %2)</source>
        <translation>全部显示（%1，逾期 %2）</translation>
    </message>
</context>
<context>
    <name>torsio::gui::CampaignDialog</name>
    <message>
        <source>New evaluation</source>
        <translation>新建模型评价</translation>
    </message>
    <message>
        <source>PM = proposed model
FEM = finite elements
MSM = mass-spring</source>
        <translation>PM = 本文模型
FEM = 有限元
MSM = 质点弹簧</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Models, one a line</source>
        <translation>模型，每行一个(&amp;M)</translation>
    </message>
    <message>
        <source>Rater</source>
        <translation>评分者</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>类别</translation>
    </message>
    <message>
        <source>No raters yet: import them under Roster.</source>
        <translation>尚无评分者：请在“人员名册”中导入。</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>创建</translation>
    </message>
    <message>
        <source>Weights of the indices</source>
        <translation>指标权重</translation>
    </message>
    <message>
        <source>Weights of the classes of raters</source>
        <translation>评分者类别权重</translation>
    </message>
    <message>
        <source>Choose raters of every class that has a weight. Missing: %1.</source>
        <translation>请为每个有权重的类别选择评分者。缺少：%1。</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>Code = name. Behind a bar (|) may stand the id of a recording made with the model, for all models or for none: the raters then watch it under its letter.</source>
        <translation>代码 = 名称。竖线（|）之后可写用该模型录制的录制编号，须为所有模型都写或都不写：评分者将在字母代号下观看录制。</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>扭转类型</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>No recordings of free practice yet.</source>
        <translation>还没有自由练习的录制。</translation>
    </message>
    <message>
        <source>Choose one recording of each model: the raters watch it under its letter.</source>
        <translation>每个模型选一份录制：评分者在字母代号下观看。</translation>
    </message>
    <message>
        <source>finite elements</source>
        <translation>有限元</translation>
    </message>
    <message>
        <source>mass-spring</source>
        <translation>质点弹簧</translation>
    </message>
    <message>
        <source>proposed model</source>
        <translation>本文模型</translation>
    </message>
    <message>
        <source>Enter a name.</source>
        <translation>请输入名称。</translation>
    </message>
    <message>
        <source>The weights must sum to 1, and sum to %1.</source>
        <translation>权重之和须为 1，目前为 %1。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Leave out raters of a class without a weight: %1.</source>
        <translation>以下类别没有权重，请勿选择其评分者：%1。</translation>
    </message>
    <message numerus="yes">
        <source>%n rater(s) chosen.</source>
        <translation>
            <numerusform>已选 %n 名评分者。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::CampaignsPage</name>
    <message>
        <source>%1 (shown as %2)</source>
        <translation>%1（显示为 %2）</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>demonstration</source>
        <translation>演示</translation>
    </message>
    <message>
        <source>Raters of %1</source>
        <translation>%1 的评分者</translation>
    </message>
    <message>
        <source>done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>not begun</source>
        <translation>未开始</translation>
    </message>
    <message>
        <source>begun</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>Evaluation of models</source>
        <translation>模型评价</translation>
    </message>
    <message>
        <source>Raters score tissue models on nine indices; they see letters, not names, in an order of their own.</source>
        <translation>评分者按九项指标为组织模型评分；他们只看到字母而非名称，顺序各不相同。</translation>
    </message>
    <message>
        <source>&amp;New evaluation…</source>
        <translation>新建评价(&amp;N)…</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Raters</source>
        <translation>评分者</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>评分</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>性质</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>创建时间</translation>
    </message>
    <message>
        <source>No evaluation yet. An evaluation asks raters of three classes to score models on nine indices.</source>
        <translation>尚无模型评价。评价请三类评分者按九项指标为模型评分。</translation>
    </message>
    <message>
        <source>Rater</source>
        <translation>评分者</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>类别</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Choose an evaluation.</source>
        <translation>请选择一项评价。</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
</context>
<context>
    <name>torsio::gui::CasePage</name>
    <message>
        <source>The recording could not be opened.</source>
        <translation>无法打开录制。</translation>
    </message>
    <message>
        <source>Draft found and opened</source>
        <translation>已找到并打开草稿</translation>
    </message>
    <message>
        <source>This case is scored live; there is no recording.</source>
        <translation>此案例为现场评分，没有录制。</translation>
    </message>
    <message>
        <source>The recording is being opened. You may score meanwhile.</source>
        <translation>正在打开录制，您可以先评分。</translation>
    </message>
    <message>
        <source>Opening case %1</source>
        <translation>正在打开案例 %1</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>Case %1 is submitted and sealed</source>
        <translation>案例 %1 已提交并封存</translation>
    </message>
    <message>
        <source>The new version is sealed; the one before is kept</source>
        <translation>新版本已封存，原版本保留</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Makes a new version with a reason; the submitted one is kept</source>
        <translation>附理由生成新版本；已提交的版本保留</translation>
    </message>
    <message>
        <source>Submit</source>
        <translation>提交</translation>
    </message>
    <message>
        <source>Checks the sheet and asks once more (Ctrl+Enter)</source>
        <translation>检查评分表并再次确认（Ctrl+Enter）</translation>
    </message>
    <message>
        <source>Bookmark</source>
        <translation>书签</translation>
    </message>
    <message>
        <source>Bookmarks this moment for yourself (B)</source>
        <translation>为自己添加书签（B）</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>评语</translation>
    </message>
    <message>
        <source>Writes to the trainee at this moment (R)</source>
        <translation>在此刻给学员写评语（R）</translation>
    </message>
    <message>
        <source>Remark at this moment, for the trainee. Enter stores it, Esc leaves it</source>
        <translation>给学员的此刻评语。回车保存，Esc 放弃</translation>
    </message>
    <message>
        <source>Remark at this moment</source>
        <translation>此刻的评语</translation>
    </message>
    <message>
        <source>Why is the mark changed?</source>
        <translation>为什么修改评分？</translation>
    </message>
    <message>
        <source>Back to the sheet</source>
        <translation>返回评分表</translation>
    </message>
    <message>
        <source>Bookmark this moment, for yourself</source>
        <translation>为自己标记此刻</translation>
    </message>
    <message>
        <source>Remark at this moment, for the trainee</source>
        <translation>在此刻给学员写评语</translation>
    </message>
    <message>
        <source>Not assessable: type why, Enter</source>
        <translation>无法评定：输入原因，回车</translation>
    </message>
    <message>
        <source>Overall</source>
        <translation>总分</translation>
    </message>
    <message>
        <source>mark of %1</source>
        <translation>%1 的评分</translation>
    </message>
    <message>
        <source>clearing of %1</source>
        <translation>清除 %1</translation>
    </message>
    <message>
        <source>reason for %1</source>
        <translation>%1 的理由</translation>
    </message>
    <message>
        <source>comment</source>
        <translation>评论</translation>
    </message>
    <message>
        <source>clearing of the sheet</source>
        <translation>清空评分表</translation>
    </message>
    <message>
        <source>Still open: %1.</source>
        <translation>尚未填写：%1。</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Watched %1 so far; at least %2 is asked.</source>
        <translation>已观看 %1，至少需要 %2。</translation>
    </message>
    <message>
        <source>Watched %1.</source>
        <translation>已观看 %1。</translation>
    </message>
    <message>
        <source>It was played at a speed that is not allowed.</source>
        <translation>播放速度超出允许范围。</translation>
    </message>
    <message>
        <source>All rows have the same mark. Is that meant?</source>
        <translation>各项评分完全相同，是否有意如此？</translation>
    </message>
    <message>
        <source>The rows lie far apart. Is that meant?</source>
        <translation>各项分数相差很大，确定吗？</translation>
    </message>
    <message>
        <source>The overall mark lies outside the rows. Is that meant?</source>
        <translation>总评超出各项评分范围，是否有意如此？</translation>
    </message>
    <message>
        <source>Submitting seals the sheet.</source>
        <translation>提交后评分表即封存。</translation>
    </message>
    <message>
        <source>Case %1</source>
        <translation>案例 %1</translation>
    </message>
    <message>
        <source>%1 long</source>
        <translation>时长 %1</translation>
    </message>
    <message>
        <source>submitted, being amended</source>
        <translation>已提交，正在更正</translation>
    </message>
    <message>
        <source>submitted and sealed</source>
        <translation>已提交并封存</translation>
    </message>
    <message>
        <source>due %1</source>
        <translation>截止 %1</translation>
    </message>
    <message>
        <source>Change what must be changed, give the reason, seal the new version. Both versions are kept.</source>
        <translation>修改必要之处，写明理由，封存新版本。两个版本均保留。</translation>
    </message>
    <message>
        <source>Seal the new version</source>
        <translation>封存新版本</translation>
    </message>
    <message>
        <source>Submit and seal (Ctrl+Enter)</source>
        <translation>提交并封存（Ctrl+Enter）</translation>
    </message>
    <message>
        <source>Undo %1 (Ctrl+Z)</source>
        <translation>撤销%1（Ctrl+Z）</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>没有可撤销的操作</translation>
    </message>
    <message>
        <source>Redo %1 (Ctrl+Y)</source>
        <translation>重做%1（Ctrl+Y）</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>没有可重做的操作</translation>
    </message>
    <message>
        <source>Bookmarks are yours; remarks reach the trainee when the marks are released.</source>
        <translation>书签仅供您自己使用；评语在评分公布后送达学员。</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清空</translation>
    </message>
    <message>
        <source>Takes every mark, reason and comment away; Undo brings them back</source>
        <translation>清除所有评分、理由和评语；可用“撤销”恢复</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>第 %1 版</translation>
    </message>
    <message>
        <source>Version %1, %2</source>
        <translation>第 %1 版，%2</translation>
    </message>
    <message>
        <source>Version %1, %2: %3</source>
        <translation>第 %1 版，%2：%3</translation>
    </message>
    <message>
        <source>Version %1, %2, moved after the panel&apos;s marks were open: %3</source>
        <translation>第 %1 版，%2，在评分组评分公开后调整：%3</translation>
    </message>
    <message>
        <source>The panel&apos;s marks are open: a new version is flagged; the submitted one is kept</source>
        <translation>评分组的评分已公开：新版本会被标记；已提交的版本予以保留</translation>
    </message>
    <message>
        <source>The panel&apos;s marks are open: you move your mark with a reason, and it is flagged as moved after them. Both versions are kept.</source>
        <translation>评分组的评分已公开：您可说明理由后调整评分，该调整会标记为在公开之后作出。两个版本都会保留。</translation>
    </message>
    <message>
        <source>Auto-advance</source>
        <translation>自动前进</translation>
    </message>
    <message>
        <source>After each figure the next row is marked by itself</source>
        <translation>每次打分后自动选中下一行</translation>
    </message>
    <message>
        <source>Edit the nearest remark of yours</source>
        <translation>修改您最近位置的评语</translation>
    </message>
    <message>
        <source>%1 (edited)</source>
        <translation>%1（已修改）</translation>
    </message>
    <message>
        <source>%1, until it was edited: %2</source>
        <translation>%1，修改之前：%2</translation>
    </message>
    <message>
        <source>A click on the time edits the words (Shift+R: the nearest); the old ones are kept.</source>
        <translation>点击时间即可修改文字（Shift+R：最近的一条）；原文保留。</translation>
    </message>
    <message>
        <source>&amp;Move with a reason…</source>
        <translation>说明理由并调整(&amp;M)…</translation>
    </message>
    <message>
        <source>&amp;Amend…</source>
        <translation>更正(&amp;A)…</translation>
    </message>
</context>
<context>
    <name>torsio::gui::CohortDialog</name>
    <message>
        <source>&amp;Groups</source>
        <translation>组别(&amp;G)</translation>
    </message>
    <message>
        <source>New cohort</source>
        <translation>新建批次</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>暂无</translation>
    </message>
    <message>
        <source>Group 1, Group 2, Group 3</source>
        <translation>第 1 组, 第 2 组, 第 3 组</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Description</source>
        <translation>说明(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Curriculum</source>
        <translation>课程(&amp;C)</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>创建</translation>
    </message>
    <message>
        <source>%1, version %2</source>
        <translation>%1，第 %2 版</translation>
    </message>
    <message>
        <source>Follow a curriculum</source>
        <translation>采用课程</translation>
    </message>
    <message>
        <source>The groups of the cohort go through its arms, number by number.</source>
        <translation>各组按编号依次对应课程的各分支。</translation>
    </message>
    <message>
        <source>Rename the cohort</source>
        <translation>批次改名</translation>
    </message>
    <message>
        <source>Reports made before keep the name that they were made under.</source>
        <translation>此前生成的报告保留当时的名称。</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>改名</translation>
    </message>
    <message>
        <source>Close or archive</source>
        <translation>关闭或归档</translation>
    </message>
    <message>
        <source>close: nobody trains, is enrolled, called or newly asked for sheets</source>
        <translation>关闭：不再训练、登记、叫号，也不再分派新的评分表</translation>
    </message>
    <message>
        <source>archive: closed, and left out of the lists</source>
        <translation>归档：已关闭，并且不再出现在列表中</translation>
    </message>
    <message>
        <source>open again: it trains and is scored as before</source>
        <translation>重新开放：照常训练和评分</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>步骤(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Reason</source>
        <translation>原因(&amp;R)</translation>
    </message>
    <message>
        <source>Do it</source>
        <translation>执行</translation>
    </message>
    <message>
        <source>none planned</source>
        <translation>未计划</translation>
    </message>
    <message>
        <source> points</source>
        <translation> 分</translation>
    </message>
    <message>
        <source>Differences that do not &amp;matter, up to</source>
        <translation>无关紧要的差异，不超过(&amp;M)</translation>
    </message>
    <message>
        <source>The report then tests whether groups are equal within it. It belongs to the plan: it cannot be changed later.</source>
        <translation>报告随后检验各组在此范围内是否等效。它属于研究计划：以后不能更改。</translation>
    </message>
    <message>
        <source>Enter a name for the cohort.</source>
        <translation>请输入批次名称。</translation>
    </message>
    <message>
        <source>Name the groups, with commas between, or choose a curriculum.</source>
        <translation>请用逗号分隔填写各组名称，或选择一个课程。</translation>
    </message>
    <message>
        <source>This is the present name.</source>
        <translation>与当前名称相同。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::CohortsPage</name>
    <message>
        <source>none yet</source>
        <translation>暂无</translation>
    </message>
    <message>
        <source>%1, version %2</source>
        <translation>%1，第 %2 版</translation>
    </message>
    <message>
        <source>demonstration</source>
        <translation>演示</translation>
    </message>
    <message>
        <source>Trainees of %1</source>
        <translation>%1 的学员</translation>
    </message>
    <message>
        <source>Enrol trainees</source>
        <translation>登记学员</translation>
    </message>
    <message>
        <source>Who takes part in %1? Groups are drawn later.</source>
        <translation>谁参加 %1？组别稍后抽取。</translation>
    </message>
    <message>
        <source>Follow a curriculum</source>
        <translation>采用课程</translation>
    </message>
    <message>
        <source>No curriculum is running. Publish one under Curricula and begin it.</source>
        <translation>没有进行中的课程。请在“课程”中发布并启用。</translation>
    </message>
    <message>
        <source>Back into the study</source>
        <translation>重新加入研究</translation>
    </message>
    <message>
        <source>Withdraw from the study</source>
        <translation>退出研究</translation>
    </message>
    <message>
        <source>%1 takes part again.</source>
        <translation>%1 重新参加。</translation>
    </message>
    <message>
        <source>%1 trains no further; what was recorded stays.</source>
        <translation>%1 不再训练；已有记录保留。</translation>
    </message>
    <message>
        <source>Cohorts</source>
        <translation>批次</translation>
    </message>
    <message>
        <source>Who trains together, by which curriculum, and in which group.</source>
        <translation>谁一起训练、采用哪个课程、在哪一组。</translation>
    </message>
    <message>
        <source>&amp;New cohort…</source>
        <translation>新建批次(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Enrol trainees…</source>
        <translation>登记学员(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Curriculum…</source>
        <translation>课程(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Allocation</source>
        <translation>随机分组(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Withdraw or take back…</source>
        <translation>退出或恢复(&amp;W)…</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Curriculum</source>
        <translation>课程</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>组数</translation>
    </message>
    <message>
        <source>Enrolled</source>
        <translation>已登记</translation>
    </message>
    <message>
        <source>In a group</source>
        <translation>已分组</translation>
    </message>
    <message>
        <source>Withdrew</source>
        <translation>已退出</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>性质</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>创建时间</translation>
    </message>
    <message>
        <source>No cohort yet. A cohort is a group of trainees who go through one study.</source>
        <translation>尚无批次。批次是共同参加一项研究的一批学员。</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>学员</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>组别</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Nobody is enrolled yet.</source>
        <translation>尚无人登记。</translation>
    </message>
    <message>
        <source>How many &amp;trainees…</source>
        <translation>需要多少学员(&amp;T)…</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>改名(&amp;R)…</translation>
    </message>
    <message>
        <source>Clo&amp;se or archive…</source>
        <translation>关闭或归档(&amp;S)…</translation>
    </message>
    <message>
        <source>Show arch&amp;ived</source>
        <translation>显示已归档(&amp;I)</translation>
    </message>
    <message>
        <source>Trainees of %1 (planned: differences up to %2 points do not matter)</source>
        <translation>%1 的学员（计划：不超过 %2 分的差异无关紧要）</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ComparePage</name>
    <message>
        <source>Loading the models</source>
        <translation>正在加载模型</translation>
    </message>
    <message>
        <source>%1 N m</source>
        <translation>%1 N m</translation>
    </message>
    <message>
        <source>Angle  %1°</source>
        <translation>角度  %1°</translation>
    </message>
    <message>
        <source>Largest shear  %1 kPa</source>
        <translation>最大剪应力  %1 kPa</translation>
    </message>
    <message>
        <source>Computed in %1 µs</source>
        <translation>计算用时  %1 µs</translation>
    </message>
    <message>
        <source>There is no picture to capture here</source>
        <translation>此处没有可截取的画面</translation>
    </message>
    <message>
        <source>Save film strip</source>
        <translation>保存连续画面</translation>
    </message>
    <message>
        <source>film-strip.png</source>
        <translation>film-strip.png</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG 图片 (*.png)</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>&amp;Organ</source>
        <translation>器官(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Torque</source>
        <translation>扭矩(&amp;T)</translation>
    </message>
    <message>
        <source>Shear stress</source>
        <translation>剪应力</translation>
    </message>
    <message>
        <source>Film strip…</source>
        <translation>连续画面…</translation>
    </message>
    <message>
        <source>Saves both models at five steps of the torque as one picture</source>
        <translation>将两个模型在五级扭矩下的画面合成一张图片保存</translation>
    </message>
    <message>
        <source>As in the paper</source>
        <translation>按论文公式</translation>
    </message>
    <message>
        <source>Saint-Venant</source>
        <translation>圣维南</translation>
    </message>
    <message>
        <source>Two formulations</source>
        <translation>两种公式</translation>
    </message>
    <message>
        <source>Finite elements and springs</source>
        <translation>有限元与弹簧</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记点</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ComparisonBars</name>
    <message>
        <source>others %1, from %2 to %3</source>
        <translation>他人 %1（%2 至 %3）</translation>
    </message>
    <message>
        <source>you %1</source>
        <translation>您 %1</translation>
    </message>
    <message>
        <source>%1; %2; apart by %3</source>
        <translation>%1；%2；相差 %3</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1；%2</translation>
    </message>
    <message>
        <source>Your marks beside the others&apos;</source>
        <translation>您的评分与他人评分对照</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Overall</source>
        <translation>总分</translation>
    </message>
</context>
<context>
    <name>torsio::gui::CompetenceDialog</name>
    <message>
        <source>Take from &amp;experts</source>
        <translation>取自专家(&amp;E)</translation>
    </message>
    <message>
        <source>When trainees are held to be able</source>
        <translation>学员何时被认为胜任</translation>
    </message>
    <message>
        <source>E&amp;xercise</source>
        <translation>练习(&amp;X)</translation>
    </message>
    <message>
        <source>Counts now</source>
        <translation>目前有效</translation>
    </message>
    <message>
        <source>Tolerance &amp;comes</source>
        <translation>容差来源(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Tolerance</source>
        <translation>容差(&amp;T)</translation>
    </message>
    <message>
        <source>Experts: people of</source>
        <translation>专家所在批次</translation>
    </message>
    <message>
        <source>Failures of somebody &amp;able</source>
        <translation>胜任者的失败率(&amp;A)</translation>
    </message>
    <message>
        <source>Failures of somebody &amp;not able</source>
        <translation>未胜任者的失败率(&amp;N)</translation>
    </message>
    <message>
        <source>Attempts &amp;planned</source>
        <translation>计划的尝试次数(&amp;P)</translation>
    </message>
    <message>
        <source>Most that pass &amp;wrongly</source>
        <translation>最多误通过(&amp;W)</translation>
    </message>
    <message>
        <source>Most that &amp;fail wrongly</source>
        <translation>最多误不通过(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Reason</source>
        <translation>理由(&amp;R)</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>效果</translation>
    </message>
    <message>
        <source>An attempt is a completed twist, or an untwisting. A design never changes; a new one counts for trainees who begin after it was registered.</source>
        <translation>一次尝试指一次完成的扭转或一次复位。标准登记后不再更改；新标准对登记之后才开始的学员有效。</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>登记</translation>
    </message>
    <message>
        <source>Limit %1. %2</source>
        <translation>界限 %1。%2</translation>
    </message>
    <message>
        <source>Too many would fail wrongly: plan more attempts, or rates that lie farther apart.</source>
        <translation>误不通过的人太多：请计划更多次尝试，或让两个失败率相差更大。</translation>
    </message>
    <message>
        <source>A tolerance chosen by hand needs a reason.</source>
        <translation>自行选定的容差需要说明理由。</translation>
    </message>
    <message>
        <source>Choose the cohort of the experts and take the tolerance from them.</source>
        <translation>请选择专家所在批次，并由其取得容差。</translation>
    </message>
    <message>
        <source>Registered as version %1.</source>
        <translation>已登记为第 %1 版。</translation>
    </message>
    <message numerus="yes">
        <source>%n expert(s): mean error %1°, mean and one standard deviation %2°, bound that covers nine in ten experts %3°.</source>
        <translation>
            <numerusform>%n 名专家：平均误差 %1°，均值加一个标准差 %2°，涵盖十分之九专家的上限 %3°。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::ConsentDialog</name>
    <message>
        <source>&amp;Given</source>
        <translation>已同意(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Withdrawn</source>
        <translation>已撤回(&amp;W)</translation>
    </message>
    <message>
        <source>Consents of %1</source>
        <translation>%1 的知情同意</translation>
    </message>
    <message>
        <source>Every decision is kept; the newest about a purpose counts. Enter here what was signed on paper.</source>
        <translation>每次决定都会保留，同一用途以最新的为准。纸质签署的决定请在此录入。</translation>
    </message>
    <message>
        <source>When</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Purpose</source>
        <translation>用途</translation>
    </message>
    <message>
        <source>Decision</source>
        <translation>决定</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文本版本</translation>
    </message>
    <message>
        <source>Nothing was decided yet.</source>
        <translation>尚无任何决定。</translation>
    </message>
    <message>
        <source>given</source>
        <translation>已同意</translation>
    </message>
    <message>
        <source>withdrawn</source>
        <translation>已撤回</translation>
    </message>
    <message>
        <source>&amp;Print a form…</source>
        <translation>打印表格(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Text</source>
        <translation>文本(&amp;T)</translation>
    </message>
    <message>
        <source>P&amp;urpose</source>
        <translation>用途(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Signed on</source>
        <translation>签名日期(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>How</source>
        <translation>方式</translation>
    </message>
    <message>
        <source>Signed on</source>
        <translation>签名日期</translation>
    </message>
    <message>
        <source>Consent form of %1</source>
        <translation>%1 的知情同意书</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message numerus="yes">
        <source>Enter here what all %n of them signed on paper on the same day. Every decision is kept; the newest of a person about a purpose counts.</source>
        <translation>
            <numerusform>请在此录入这 %n 人同日在纸上签署的决定。每次决定都会保留，每人对同一用途以最新的为准。</numerusform>
        </translation>
    </message>
    <message>
        <source>Person</source>
        <translation>人员</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ConsentPage</name>
    <message>
        <source>Nothing is recorded before you agree. You can withdraw later at any time.</source>
        <translation>在您同意之前不会记录任何内容。您可以随时撤回。</translation>
    </message>
    <message>
        <source>I have &amp;read and understood this</source>
        <translation>我已阅读并理解(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Not now</source>
        <translation>暂不(&amp;N)</translation>
    </message>
    <message>
        <source>You have agreed before.</source>
        <translation>您此前已同意。</translation>
    </message>
    <message>
        <source>You have not agreed so far.</source>
        <translation>您尚未同意。</translation>
    </message>
    <message>
        <source>&amp;Withdraw</source>
        <translation>撤回同意(&amp;W)</translation>
    </message>
    <message>
        <source>Nothing will be recorded. Free practice stays open.</source>
        <translation>不会记录任何内容。自由练习仍可使用。</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>知情同意</translation>
    </message>
    <message>
        <source>What else may be done</source>
        <translation>还可以同意的事项</translation>
    </message>
    <message>
        <source>Tick what you agree to. Whatever you choose, you can train.</source>
        <translation>请勾选您同意的事项。无论如何选择，您都可以训练。</translation>
    </message>
    <message>
        <source>I &amp;agree to the training record</source>
        <translation>我同意训练记录(&amp;A)</translation>
    </message>
    <message>
        <source>You have agreed before, to another text (%1). This is %2: please read it.</source>
        <translation>您之前同意的是另一份文本（%1）。现在的文本是 %2，请阅读。</translation>
    </message>
    <message>
        <source>&amp;Save these decisions</source>
        <translation>保存这些决定(&amp;S)</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ConsentTextsDialog</name>
    <message>
        <source>Add a &amp;language…</source>
        <translation>添加语言(&amp;L)…</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>添加(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>删除(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Publish…</source>
        <translation>发布(&amp;P)…</translation>
    </message>
    <message>
        <source>Consent texts</source>
        <translation>知情同意文本</translation>
    </message>
    <message>
        <source>What people are asked to agree to, in each language. A change becomes the next version; what was agreed to before stays under its own. Let your data protection officer read it first.</source>
        <translation>以各种语言列出征求同意的内容。每次修改都成为下一版本；此前的同意仍属于其当时的版本。请先交数据保护负责人审阅。</translation>
    </message>
    <message>
        <source>&amp;Version</source>
        <translation>版本(&amp;V)</translation>
    </message>
    <message>
        <source>La&amp;nguage</source>
        <translation>语言(&amp;N)</translation>
    </message>
    <message>
        <source>P&amp;urposes</source>
        <translation>用途(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Title</source>
        <translation>标题(&amp;T)</translation>
    </message>
    <message>
        <source>Te&amp;xt</source>
        <translation>正文(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>%1 (as it ships)</source>
        <translation>%1（随程序提供）</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>(no title)</source>
        <translation>（无标题）</translation>
    </message>
    <message>
        <source>The training record stays: without it nothing may be recorded</source>
        <translation>训练记录必须保留：没有它就不能记录任何内容</translation>
    </message>
    <message>
        <source>Publish first: a form names the version of its text</source>
        <translation>请先发布：表格上注明文本的版本</translation>
    </message>
    <message>
        <source>Add a language</source>
        <translation>添加语言</translation>
    </message>
    <message>
        <source>Its code as on web pages, such as de, fr or pt_BR. The texts of the language that is shown are copied for you to translate.</source>
        <translation>请填写网页所用的语言代码，例如 de、fr 或 pt_BR。当前语言的文本会复制一份供您翻译。</translation>
    </message>
    <message>
        <source>&amp;Code</source>
        <translation>代码(&amp;C)</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Publish</source>
        <translation>发布</translation>
    </message>
    <message>
        <source>Everybody is asked with these texts from now on. Earlier decisions stay; whoever has decided about an earlier text is told so on their page. What has changed?</source>
        <translation>今后将用这些文本征求所有人的同意。此前的决定保留；曾就较早文本作出决定的人会在其页面上看到提示。改动了什么？</translation>
    </message>
    <message>
        <source>%1 is asked from now on</source>
        <translation>今后使用 %1 征求同意</translation>
    </message>
    <message>
        <source>Consent forms to sign</source>
        <translation>待签名的知情同意书</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message numerus="yes">
        <source>%n form(s) written, the last one without a code</source>
        <translation>
            <numerusform>已写出 %n 份表格，最后一份没有编码</numerusform>
        </translation>
    </message>
    <message>
        <source>Close without publishing</source>
        <translation>不发布就关闭</translation>
    </message>
    <message>
        <source>The changes are not published and will be lost.</source>
        <translation>改动尚未发布，将会丢失。</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>放弃改动(&amp;D)</translation>
    </message>
    <message>
        <source>Give the purpose a title.</source>
        <translation>请填写该用途的标题。</translation>
    </message>
    <message>
        <source>Say what people agree to.</source>
        <translation>请写明同意的内容。</translation>
    </message>
    <message>
        <source>Purpose %1 has no title or no text in this language yet: %2.</source>
        <translation>第 %1 项用途在此语言中还没有标题或正文：%2。</translation>
    </message>
    <message>
        <source>Print &amp;forms…</source>
        <translation>打印表格(&amp;F)…</translation>
    </message>
</context>
<context>
    <name>torsio::gui::CredentialsDialog</name>
    <message>
        <source>Sign-in &amp;name</source>
        <translation>登录名(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Password</source>
        <translation>密码(&amp;P)</translation>
    </message>
</context>
<context>
    <name>torsio::gui::CurriculaPage</name>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>暂无</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>草稿</translation>
    </message>
    <message>
        <source>Version %1 (%2)</source>
        <translation>第 %1 版（%2）</translation>
    </message>
    <message>
        <source>The draft is saved.</source>
        <translation>草稿已保存。</translation>
    </message>
    <message>
        <source>Published. Begin it, so that cohorts can follow it.</source>
        <translation>已发布。启用后批次才能采用。</translation>
    </message>
    <message>
        <source>It runs: cohorts can follow it now.</source>
        <translation>已启用：批次现在可以采用。</translation>
    </message>
    <message>
        <source>Edit as draft</source>
        <translation>作为草稿编辑</translation>
    </message>
    <message>
        <source>The draft differs from version %1. Put this version in its place? Published versions stay as they are.</source>
        <translation>草稿与第 %1 版不同。是否用此版本替换草稿？已发布的版本保持不变。</translation>
    </message>
    <message>
        <source>New curriculum</source>
        <translation>新建课程</translation>
    </message>
    <message>
        <source>nothing in it yet</source>
        <translation>空白</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Begin with</source>
        <translation>起点(&amp;B)</translation>
    </message>
    <message>
        <source>Publish a version</source>
        <translation>发布版本</translation>
    </message>
    <message>
        <source>A published version never changes. What is new in it, in a few words:</source>
        <translation>已发布的版本不再改变。请简述本版的新内容：</translation>
    </message>
    <message>
        <source>Close a version</source>
        <translation>关闭版本</translation>
    </message>
    <message>
        <source>No further cohort can begin it; those who follow it go on.</source>
        <translation>不再有新批次可采用；已采用的继续进行。</translation>
    </message>
    <message>
        <source>Curricula</source>
        <translation>课程</translation>
    </message>
    <message>
        <source>What the groups go through: exercises, phases, rest and occasions. Published versions never change.</source>
        <translation>各组的训练内容：练习、阶段、休息和评分时点。已发布的版本不再改变。</translation>
    </message>
    <message>
        <source>&amp;New curriculum…</source>
        <translation>新建课程(&amp;N)…</translation>
    </message>
    <message>
        <source>S&amp;howing</source>
        <translation>显示(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Edit as draft</source>
        <translation>作为草稿编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Save draft</source>
        <translation>保存草稿(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Publish…</source>
        <translation>发布(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Begin</source>
        <translation>开始(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Close…</source>
        <translation>关闭(&amp;C)…</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Newest version</source>
        <translation>最新版本</translation>
    </message>
    <message>
        <source>No curriculum yet. Begin with the template of the paper&apos;s three arms.</source>
        <translation>尚无课程。可从论文的三组方案模板开始。</translation>
    </message>
    <message>
        <source>Add an occasion</source>
        <translation>添加评分时点</translation>
    </message>
    <message>
        <source>It comes after all others, for every curriculum from now on, and is never taken away. What is it called?</source>
        <translation>它排在所有其他评分时点之后，今后的所有课程均可使用，且不会被移除。它叫什么名称？</translation>
    </message>
    <message>
        <source>Occasion added: %1</source>
        <translation>已添加评分时点：%1</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>创建</translation>
    </message>
    <message>
        <source>Co&amp;mpetence…</source>
        <translation>胜任标准(&amp;M)…</translation>
    </message>
    <message>
        <source>Where to draw the &amp;line…</source>
        <translation>及格线划在哪里(&amp;L)…</translation>
    </message>
</context>
<context>
    <name>torsio::gui::CurriculumEditor</name>
    <message>
        <source>%1 %2. %3.</source>
        <translation>%1：%2。%3。</translation>
    </message>
    <message>
        <source>✓ Nothing is missing: this can be published.</source>
        <translation>✓ 内容完整，可以发布。</translation>
    </message>
    <message>
        <source>Check: complete</source>
        <translation>检查：完整</translation>
    </message>
    <message numerus="yes">
        <source>Check: %n to mend</source>
        <translation>
            <numerusform>检查：%n 处待改</numerusform>
        </translation>
    </message>
    <message>
        <source>Exercises</source>
        <translation>练习</translation>
    </message>
    <message>
        <source>Groups and phases</source>
        <translation>组别与阶段</translation>
    </message>
    <message>
        <source>Occasions</source>
        <translation>评分时点</translation>
    </message>
    <message>
        <source>When the raters score everybody, counted in minutes of training (rest does not count). The paper scores before, after 20 and after 40 minutes. A follow-up, weeks after the training, has the minutes of the occasion before it.</source>
        <translation>评分者何时为所有人评分，以训练分钟数计（休息不计）。论文在训练前、20 分钟后和 40 分钟后评分。训练结束数周后的随访，沿用前一个时点的分钟数。</translation>
    </message>
    <message>
        <source>after </source>
        <translation>训练 </translation>
    </message>
    <message>
        <source> min</source>
        <translation> 分钟</translation>
    </message>
    <message>
        <source>Minutes of training before: %1</source>
        <translation>评分前的训练分钟数：%1</translation>
    </message>
    <message>
        <source>What is still to mend</source>
        <translation>尚待修正</translation>
    </message>
    <message>
        <source>Add an &amp;occasion…</source>
        <translation>添加评分时点(&amp;O)…</translation>
    </message>
</context>
<context>
    <name>torsio::gui::DataTable</name>
    <message numerus="yes">
        <source>%n row(s)</source>
        <translation>
            <numerusform>%n 行</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Together: %1</source>
        <translation>合计：%1</translation>
    </message>
    <message>
        <source>Filter…</source>
        <translation>筛选…</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>Copy with headers</source>
        <translation>连同表头复制</translation>
    </message>
    <message>
        <source>Sort by this column</source>
        <translation>按此列排序</translation>
    </message>
    <message>
        <source>Columns…</source>
        <translation>列…</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n row(s)</source>
        <translation>
            <numerusform>%1 / %n 行</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::DayPlanDialog</name>
    <message>
        <source>Plan of the day</source>
        <translation>当日计划</translation>
    </message>
    <message>
        <source> min</source>
        <translation> 分钟</translation>
    </message>
    <message>
        <source>Station 1, Station 2, Room 3</source>
        <translation>工作站 1, 工作站 2, 房间 3</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Add %n trainee(s) to the plan</source>
        <translation>
            <numerusform>将 %n 名学员加入计划(&amp;A)</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>删除(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>打印(&amp;P)…</translation>
    </message>
    <message>
        <source>Trainees come in the order of the board, as many at a time as there are places. Swapping turns on the board swaps slots, too; whoever has not begun five minutes after the start is shown as overdue.</source>
        <translation>学员按总览的顺序到来，每次的人数等于地点数。在总览中互换次序时，时段也随之互换；开始五分钟后仍未开始者显示为逾期。</translation>
    </message>
    <message>
        <source>&amp;Day</source>
        <translation>日期(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;First slot begins at</source>
        <translation>首个时段开始于(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Each takes</source>
        <translation>每段时长(&amp;E)</translation>
    </message>
    <message>
        <source>Pa&amp;use between two</source>
        <translation>两段之间的间隔(&amp;U)</translation>
    </message>
    <message>
        <source>Stations and roo&amp;ms, with commas</source>
        <translation>工作站和房间，以逗号分隔(&amp;M)</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>至</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>地点</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>学员</translation>
    </message>
    <message>
        <source>Nobody is planned for this day yet.</source>
        <translation>该日尚未安排任何人。</translation>
    </message>
    <message>
        <source>Plan of %1</source>
        <translation>%1 的计划</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Began at</source>
        <translation>实际开始</translation>
    </message>
    <message>
        <source>Print the plan</source>
        <translation>打印计划</translation>
    </message>
    <message>
        <source>Plan %1.pdf</source>
        <translation>计划 %1.pdf</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Name at least one place.</source>
        <translation>请至少填写一个地点。</translation>
    </message>
    <message>
        <source>! That would take longer than this day: name more places, or choose fewer trainees.</source>
        <translation>! 这一天排不下：请增加地点，或少选几名学员。</translation>
    </message>
    <message>
        <source>! The last slot ends at %1. The first one has begun already: whoever is not there is overdue.</source>
        <translation>! 最后一个时段于 %1 结束。第一个时段已经开始：未到者即为逾期。</translation>
    </message>
    <message>
        <source>The last slot ends at %1.</source>
        <translation>最后一个时段于 %1 结束。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::DebriefPage</name>
    <message>
        <source>Looking at your run</source>
        <translation>正在分析您的操作</translation>
    </message>
    <message>
        <source>Bookmark at %1</source>
        <translation>已在 %1 处添加书签</translation>
    </message>
    <message>
        <source>Look at %1 to %2</source>
        <translation>查看 %1 至 %2</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>What went well</source>
        <translation>做得好的地方</translation>
    </message>
    <message>
        <source>What to work on</source>
        <translation>需要改进的地方</translation>
    </message>
    <message>
        <source>The run</source>
        <translation>操作过程</translation>
    </message>
    <message>
        <source>Show the &amp;expert (dashed)</source>
        <translation>显示专家曲线（虚线）(&amp;E)</translation>
    </message>
    <message>
        <source>Set &amp;bookmark</source>
        <translation>添加书签(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Whole run</source>
        <translation>整个操作(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Again</source>
        <translation>再来一次(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Trend</source>
        <translation>趋势(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Next step</source>
        <translation>下一步(&amp;N)</translation>
    </message>
    <message>
        <source>Graded run</source>
        <translation>计分操作</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>练习</translation>
    </message>
    <message>
        <source>Your run</source>
        <translation>您的操作</translation>
    </message>
    <message>
        <source>One moment: your run is compared with what was asked for and with an expert&apos;s.</source>
        <translation>请稍候：正在将您的操作与要求及专家的操作进行比较。</translation>
    </message>
    <message>
        <source>After your first run you see here what was good and what to work on.</source>
        <translation>完成第一次操作后，这里会显示优点和需要改进之处。</translation>
    </message>
    <message>
        <source>Interrupted: kept, not counted</source>
        <translation>已中断：已保存，不计次数</translation>
    </message>
    <message>
        <source>Passed: every target was reached</source>
        <translation>通过：所有目标均已达到</translation>
    </message>
    <message>
        <source>Not passed yet</source>
        <translation>尚未通过</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>not passed</source>
        <translation>未通过</translation>
    </message>
    <message>
        <source>No twist was finished in this run.</source>
        <translation>本次操作没有完成任何扭转。</translation>
    </message>
    <message>
        <source>There is no expert&apos;s run to compare with.</source>
        <translation>没有可供比较的专家操作。</translation>
    </message>
    <message>
        <source>Force was shown, not felt: the device of this run gives none. Its measures are computed.</source>
        <translation>力只显示、感觉不到：本次操作的设备不提供力。力的测量值由模型计算。</translation>
    </message>
    <message>
        <source>Your run in 3D</source>
        <translation>您的操作（三维）</translation>
    </message>
    <message>
        <source>Judged is the force on the tissue. The device gave at most %1 N of it.</source>
        <translation>评判的是组织所受的力。设备最多输出了其中的 %1 N。</translation>
    </message>
    <message>
        <source>What was felt was not what was computed all the time: %1. %2.</source>
        <translation>手上感受到的力并非始终与计算值一致：%1。%2。</translation>
    </message>
    <message numerus="yes">
        <source>%n twist(s) not completed and not counted.</source>
        <translation>
            <numerusform>有 %n 次扭转未完成，不计入。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1  ·  %2  ·  %3</source>
        <translation>%1  ·  %2  ·  %3</translation>
    </message>
    <message>
        <source>One run decides nothing. By all runs: %1. %2 %3</source>
        <translation>单次操作不作定论。按全部操作：%1。%2%3</translation>
    </message>
</context>
<context>
    <name>torsio::gui::DebriefPlot</name>
    <message>
        <source>Angle and force of the run over time</source>
        <translation>操作过程中的角度和力</translation>
    </message>
    <message>
        <source>Wheel zooms, dragging moves, a double click sets a bookmark</source>
        <translation>滚轮缩放，拖动移动，双击添加书签</translation>
    </message>
    <message>
        <source>Angle in degrees</source>
        <translation>角度（度）</translation>
    </message>
    <message>
        <source>Force in N</source>
        <translation>力（N）</translation>
    </message>
    <message>
        <source>%1   %2°   %3 N</source>
        <translation>%1   %2°   %3 N</translation>
    </message>
    <message>
        <source>Twists: %1, in %2. Plus and minus zoom, arrows move, B sets a bookmark.</source>
        <translation>扭转 %1 次，共 %2。加减号缩放，方向键移动，B 添加书签。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::DebriefReplay</name>
    <message>
        <source>Your run in three dimensions; the expert&apos;s organ shines through</source>
        <translation>您的操作的三维画面；专家的器官以半透明显示</translation>
    </message>
    <message>
        <source>Time in the run, for your run and the expert&apos;s</source>
        <translation>操作中的时间，同时控制您和专家的画面</translation>
    </message>
    <message>
        <source>Plays or pauses</source>
        <translation>播放或暂停</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
</context>
<context>
    <name>torsio::gui::Desk</name>
    <message>
        <source>This page is not open to you</source>
        <translation>您无权打开此页面</translation>
    </message>
    <message>
        <source>A run is going on. Finish or stop it first</source>
        <translation>操作正在进行，请先完成或停止</translation>
    </message>
    <message>
        <source>The database does not answer now. This page opens as soon as it does</source>
        <translation>数据库目前没有应答。恢复后即可打开此页面</translation>
    </message>
    <message>
        <source>Work is going on. Wait for it, or cancel it</source>
        <translation>有任务正在进行，请等待完成或取消</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Light or dark colours</source>
        <translation>浅色或深色</translation>
    </message>
    <message>
        <source>Keys and help (F1)</source>
        <translation>按键与帮助 (F1)</translation>
    </message>
    <message>
        <source>Guest</source>
        <translation>访客</translation>
    </message>
    <message>
        <source>Your account</source>
        <translation>您的账户</translation>
    </message>
    <message>
        <source>End</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>Sign out</source>
        <translation>退出登录</translation>
    </message>
    <message>
        <source>Practice: nothing is recorded</source>
        <translation>练习：不作任何记录</translation>
    </message>
    <message>
        <source>Change password…</source>
        <translation>修改密码…</translation>
    </message>
    <message>
        <source>PIN for practice…</source>
        <translation>练习用 PIN 码…</translation>
    </message>
    <message>
        <source>Lock now</source>
        <translation>立即锁定</translation>
    </message>
    <message>
        <source>Remove demonstration data…</source>
        <translation>删除演示数据…</translation>
    </message>
    <message>
        <source>About Torsio</source>
        <translation>关于 Torsio</translation>
    </message>
    <message>
        <source>Enter as a simulated trainee</source>
        <translation>以模拟学员身份进入</translation>
    </message>
</context>
<context>
    <name>torsio::gui::DetorsionCard</name>
    <message>
        <source>Over the time of the tissue</source>
        <translation>随组织时间的变化</translation>
    </message>
    <message>
        <source>Where the seconds went</source>
        <translation>时间用在哪里</translation>
    </message>
    <message>
        <source>What the numbers say</source>
        <translation>数据说明</translation>
    </message>
    <message>
        <source>Searching, nothing held</source>
        <translation>寻找，无任何固定</translation>
    </message>
    <message>
        <source>Turning in the jaw</source>
        <translation>钳口内转动</translation>
    </message>
    <message>
        <source>Held by the clip alone</source>
        <translation>仅由夹子固定</translation>
    </message>
    <message>
        <source>Checking the blood flow</source>
        <translation>检查血流</translation>
    </message>
    <message>
        <source>Waiting with hands off</source>
        <translation>松手等待</translation>
    </message>
    <message>
        <source>The first turn went the right way.</source>
        <translation>第一次转动方向正确。</translation>
    </message>
    <message>
        <source>The first turn went the wrong way.</source>
        <translation>第一次转动方向错误。</translation>
    </message>
    <message>
        <source>The organ was turned %1 further in than it came.</source>
        <translation>器官比开始时多扭了 %1。</translation>
    </message>
    <message>
        <source>Blood flowed again after %1, which is %2 of the tissue.</source>
        <translation>%1 后血流恢复，相当于组织时间 %2。</translation>
    </message>
    <message>
        <source>Blood did not come back in this run.</source>
        <translation>本次操作中血流未恢复。</translation>
    </message>
    <message>
        <source>The ischaemic dose came to %1: from 1 on the tissue is lost.</source>
        <translation>缺血剂量达到 %1：达到 1 则组织坏死。</translation>
    </message>
    <message>
        <source>The ischaemic dose came to %1: the tissue lives, 1 would be its loss.</source>
        <translation>缺血剂量为 %1：组织存活，达到 1 则坏死。</translation>
    </message>
    <message>
        <source>Re-grips: %1; a hand of usual reach needs at least %2.</source>
        <translation>重新抓持：%1 次；一般手的转动范围至少需要 %2 次。</translation>
    </message>
    <message>
        <source>Between grips %1 were lost again: set the clip before you let go.</source>
        <translation>两次抓持之间又回转了 %1：松手前请先上夹子。</translation>
    </message>
    <message>
        <source>The tissue was loaded beyond what it bears for %1.</source>
        <translation>组织超负荷 %1。</translation>
    </message>
    <message>
        <source>It turned back after it had been undone.</source>
        <translation>复位后又回转。</translation>
    </message>
    <message>
        <source>Twist that remains: %1.</source>
        <translation>剩余扭转：%1。</translation>
    </message>
    <message>
        <source>Bruises by the jaw: %1. Grip with less force, ischaemic tissue bears half.</source>
        <translation>钳伤：%1 处。夹持要轻，缺血组织只能承受一半的压力。</translation>
    </message>
    <message>
        <source>Bruises, tears, slips and relapses are not marked: the organ of this run is not on this machine.</source>
        <translation>未标出钳伤、撕裂、滑脱和回转：本机没有此次操作的器官。</translation>
    </message>
    <message>
        <source>Enough blood flowed from the beginning on.</source>
        <translation>血流从一开始就足够。</translation>
    </message>
    <message>
        <source>Undone in stages: at most %1 without a rest.</source>
        <translation>已分阶段复位：未停歇时最多转 %1。</translation>
    </message>
    <message>
        <source>Turned back by %1 without a rest: let the blood return in stages.</source>
        <translation>未停歇就转回了 %1：应分阶段让血流恢复。</translation>
    </message>
    <message>
        <source>Times that the instrument slipped off: %1.</source>
        <translation>器械滑脱：%1 次。</translation>
    </message>
    <message>
        <source>Tears of the wall: %1. A torn organ does not count as undone.</source>
        <translation>壁撕裂：%1 处。器官撕裂不算复位。</translation>
    </message>
    <message>
        <source>%1: %2 (%3 %)</source>
        <translation>%1：%2（%3 %）</translation>
    </message>
</context>
<context>
    <name>torsio::gui::DetorsionPanel</name>
    <message>
        <source>Untwisting</source>
        <translation>复位</translation>
    </message>
    <message>
        <source>Twist left</source>
        <translation>剩余扭转</translation>
    </message>
    <message>
        <source>Lumen</source>
        <translation>管腔</translation>
    </message>
    <message>
        <source>Gas pressure</source>
        <translation>气体压力</translation>
    </message>
    <message>
        <source>Tissue time</source>
        <translation>组织时间</translation>
    </message>
    <message>
        <source>Blood flow, as told</source>
        <translation>所测血流</translation>
    </message>
    <message>
        <source>1 s here = %1 s of the tissue</source>
        <translation>此处 1 秒 = 组织 %1 秒</translation>
    </message>
    <message>
        <source>1 s here = 1 min of the tissue</source>
        <translation>此处 1 秒 = 组织 1 分钟</translation>
    </message>
    <message>
        <source>Clip (C)</source>
        <translation>夹子 (C)</translation>
    </message>
    <message>
        <source>A clip or an assistant holds the organ while you grip anew</source>
        <translation>您重新抓持时，由夹子或助手固定器官</translation>
    </message>
    <message>
        <source>Gas out (V)</source>
        <translation>排气 (V)</translation>
    </message>
    <message>
        <source>Let gas out: the organ turns more easily and its lumen closes sooner</source>
        <translation>排气：器官更易转动，但管腔更早闭合</translation>
    </message>
    <message>
        <source>Check the blood flow</source>
        <translation>检查血流</translation>
    </message>
    <message>
        <source>%1 (%2): %3 s, ± %4 %</source>
        <translation>%1 (%2)：%3 秒，± %4 %</translation>
    </message>
    <message>
        <source>Progress of the check</source>
        <translation>检查进度</translation>
    </message>
    <message>
        <source>Time with hands off</source>
        <translation>松手时间</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Untwisting: clip</source>
        <translation>复位：夹子</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>Untwisting: let gas out</source>
        <translation>复位：排气</translation>
    </message>
    <message>
        <source>V</source>
        <translation>V</translation>
    </message>
    <message>
        <source>Untwisting: look, feel the pulse, Doppler</source>
        <translation>复位：观察、触摸搏动、多普勒</translation>
    </message>
    <message>
        <source>1, 2, 3</source>
        <translation>1、2、3</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>观察</translation>
    </message>
    <message>
        <source>Feel the pulse</source>
        <translation>触摸搏动</translation>
    </message>
    <message>
        <source>Doppler</source>
        <translation>多普勒</translation>
    </message>
    <message>
        <source>%1° · %2 turns</source>
        <translation>%1° · %2 圈</translation>
    </message>
    <message>
        <source>%1 clockwise</source>
        <translation>%1，顺时针</translation>
    </message>
    <message>
        <source>%1 counterclockwise</source>
        <translation>%1，逆时针</translation>
    </message>
    <message>
        <source>%1:%2 h</source>
        <translation>%1:%2 小时</translation>
    </message>
    <message>
        <source>open, %1 %</source>
        <translation>通畅，%1 %</translation>
    </message>
    <message>
        <source>closed, %1 %</source>
        <translation>闭合，%1 %</translation>
    </message>
    <message>
        <source>narrow, %1 %</source>
        <translation>狭窄，%1 %</translation>
    </message>
    <message>
        <source>%1 mmHg</source>
        <translation>%1 mmHg</translation>
    </message>
    <message>
        <source>%1…</source>
        <translation>%1…</translation>
    </message>
    <message>
        <source>not checked</source>
        <translation>未检查</translation>
    </message>
    <message>
        <source>%1: %2 % ± %3 %</source>
        <translation>%1：%2 % ± %3 %</translation>
    </message>
    <message>
        <source>Within the limits. Take the hand and the clip off.</source>
        <translation>已在限度内。请松手并取下夹子。</translation>
    </message>
    <message>
        <source>Hands off: %1 of %2 s</source>
        <translation>松手：%1 / %2 秒</translation>
    </message>
    <message>
        <source>It stays. Check the blood flow before you end.</source>
        <translation>位置稳定。结束前请检查血流。</translation>
    </message>
    <message>
        <source>The wall is torn: the content leaks.</source>
        <translation>管壁撕裂：内容物外漏。</translation>
    </message>
    <message>
        <source>The jaw presses too hard: %1 kPa.</source>
        <translation>钳口压力过大：%1 kPa。</translation>
    </message>
    <message>
        <source>Bruises of the wall: %1</source>
        <translation>管壁挫伤：%1 处</translation>
    </message>
    <message>
        <source>Clip off (C)</source>
        <translation>取下夹子 (C)</translation>
    </message>
    <message>
        <source>Gas stop (V)</source>
        <translation>停止排气 (V)</translation>
    </message>
    <message>
        <source>The clip holds it. Take the clip off (C), then turn on.</source>
        <translation>夹子固定着器官。先取下夹子 (C)，再继续转动。</translation>
    </message>
    <message>
        <source>The clip holds it. Grip anew, then take the clip off (C).</source>
        <translation>夹子固定着器官。重新抓持，再取下夹子 (C)。</translation>
    </message>
    <message>
        <source>It lies within the limits. Keep your hands off, check the blood flow.</source>
        <translation>已在限度之内。请松手，并检查血流。</translation>
    </message>
    <message>
        <source>It lies within the limits. Let go.</source>
        <translation>已在限度之内。请松开。</translation>
    </message>
    <message>
        <source>Holding. Turn, set the clip (C), then grip anew.</source>
        <translation>已抓住。转动，上夹子 (C)，再重新抓持。</translation>
    </message>
    <message>
        <source>Rest of the tissue</source>
        <translation>组织停歇</translation>
    </message>
    <message>
        <source>The twist grows. Turn in the opposite direction.</source>
        <translation>扭转正在加重。请向相反方向转动。</translation>
    </message>
    <message>
        <source>Your hand is turned as far as it goes. Set the clip (C), open the jaw, grip anew.</source>
        <translation>手已转到极限。请上夹子 (C)，松开钳口，再重新抓持。</translation>
    </message>
    <message>
        <source>%1, %2 ago</source>
        <translation>%1，%2 前</translation>
    </message>
    <message>
        <source>Turned back by %1°. Set the clip and let it rest: %2 of %3</source>
        <translation>已转回 %1°。请夹住并让组织停歇：%2 / %3</translation>
    </message>
</context>
<context>
    <name>torsio::gui::DetorsionPlot</name>
    <message>
        <source>Angle, blood flow and dose over the time of the tissue</source>
        <translation>角度、血流和缺血剂量随组织时间的变化</translation>
    </message>
    <message>
        <source>Angle from %1 to %2, blood flow from %3 to %4 %, dose from %5 to %6, in %7 of the tissue.</source>
        <translation>角度从 %1 到 %2，血流从 %3 到 %4 %，剂量从 %5 到 %6，历时组织时间 %7。</translation>
    </message>
    <message>
        <source>grip</source>
        <translation>抓持</translation>
    </message>
    <message>
        <source>let go</source>
        <translation>松开</translation>
    </message>
    <message>
        <source>clip on</source>
        <translation>上夹</translation>
    </message>
    <message>
        <source>clip off</source>
        <translation>取夹</translation>
    </message>
    <message>
        <source>gas out</source>
        <translation>排气</translation>
    </message>
    <message>
        <source>way out closed</source>
        <translation>停止排气</translation>
    </message>
    <message>
        <source>check</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>Angle in degrees</source>
        <translation>角度（度）</translation>
    </message>
    <message>
        <source>Blood flow in % of the untwisted organ</source>
        <translation>血流（占未扭转器官的 %）</translation>
    </message>
    <message>
        <source>Ischaemic dose: from 1 on the tissue is lost</source>
        <translation>缺血剂量：达到 1 则组织坏死</translation>
    </message>
    <message>
        <source>Angle, blood flow, dose and pressure over the time of the tissue</source>
        <translation>角度、血流、缺血剂量和压力随组织时间的变化</translation>
    </message>
    <message>
        <source>Pressure from %1 to %2 mmHg.</source>
        <translation>压力从 %1 到 %2 mmHg。</translation>
    </message>
    <message>
        <source>bruise</source>
        <translation>钳伤</translation>
    </message>
    <message>
        <source>tear</source>
        <translation>撕裂</translation>
    </message>
    <message>
        <source>slipped off</source>
        <translation>滑脱</translation>
    </message>
    <message>
        <source>turns back</source>
        <translation>回转</translation>
    </message>
    <message>
        <source>Pressure of the content in mmHg</source>
        <translation>内容物压力（mmHg）</translation>
    </message>
    <message>
        <source>%1 at %2 (%3 of the tissue)</source>
        <translation>%1，%2（组织时间 %3）</translation>
    </message>
</context>
<context>
    <name>torsio::gui::DeviationsDialog</name>
    <message>
        <source>Deviations</source>
        <translation>方案偏离</translation>
    </message>
    <message>
        <source>When</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>学员</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>性质</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>说明</translation>
    </message>
    <message>
        <source>No deviation was noted.</source>
        <translation>没有记录任何方案偏离。</translation>
    </message>
    <message>
        <source>Entered in &amp;error…</source>
        <translation>误录(&amp;E)…</translation>
    </message>
    <message>
        <source>Notes beside the chosen ones that they are wrong, and why; nothing is removed</source>
        <translation>在所选各条旁注明有误及原因；不删除任何内容</translation>
    </message>
    <message>
        <source>What went otherwise than the protocol says. The report lists it as well.</source>
        <translation>与方案不符的情况，报告中也会列出。</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>the whole cohort</source>
        <translation>整个批次</translation>
    </message>
    <message>
        <source>Entered in error</source>
        <translation>误录</translation>
    </message>
    <message numerus="yes">
        <source>%n deviation(s) stay as they are; a correction with this reason stands beside each, in the report as well.</source>
        <translation>
            <numerusform>%n 条方案偏离保持原样；每条旁附上含此理由的更正，报告中亦然。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::DeviceCheckPage</name>
    <message>
        <source>Checking the device</source>
        <translation>正在检查设备</translation>
    </message>
    <message>
        <source>Is everything ready?</source>
        <translation>是否一切就绪？</translation>
    </message>
    <message>
        <source>This station has no haptic device: you work with mouse and keyboard.</source>
        <translation>本工作站没有力反馈设备：请使用鼠标和键盘。</translation>
    </message>
    <message>
        <source>Sit down, put the stylus into its dock, and rest your forearm.</source>
        <translation>请坐好，将手柄放回底座，前臂放松。</translation>
    </message>
    <message>
        <source>Practise with the &amp;mouse</source>
        <translation>用鼠标练习(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Practise</source>
        <translation>练习(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Continue to the graded run</source>
        <translation>继续计分操作(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Continue</source>
        <translation>继续(&amp;C)</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>正在检查…</translation>
    </message>
    <message>
        <source>This takes a few seconds.</source>
        <translation>需要几秒钟。</translation>
    </message>
    <message>
        <source>Everything is in order. Practice and graded runs may begin.</source>
        <translation>一切正常。可以开始练习和计分操作。</translation>
    </message>
    <message>
        <source>Good enough to practise. A graded run needs every line to be in order.</source>
        <translation>可以练习。计分操作要求每一项都正常。</translation>
    </message>
    <message>
        <source>Something is wrong. No graded run with this device now.</source>
        <translation>设备有问题，目前不能用它进行计分操作。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Sit down and take the device into your hand.</source>
        <translation>请坐好，把设备拿在手中。</translation>
    </message>
    <message>
        <source>Check &amp;again</source>
        <translation>重新检查(&amp;A)</translation>
    </message>
</context>
<context>
    <name>torsio::gui::DevicesPage</name>
    <message>
        <source>Checking the device</source>
        <translation>正在检查设备</translation>
    </message>
    <message>
        <source>✓ good</source>
        <translation>✓ 正常</translation>
    </message>
    <message>
        <source>! note</source>
        <translation>! 注意</translation>
    </message>
    <message>
        <source>✗ not usable</source>
        <translation>✗ 不可用</translation>
    </message>
    <message>
        <source>Not checked yet in this session. The check takes a few seconds; put the stylus into the inkwell first.</source>
        <translation>本次尚未检查。检查需几秒钟；请先将手写笔插入笔座。</translation>
    </message>
    <message>
        <source>This station can do graded runs with the device: %1 servo ticks a second.</source>
        <translation>本工作站可用该设备进行计分操作：每秒 %1 个伺服周期。</translation>
    </message>
    <message>
        <source>No graded run with the device now: %1. Practice with the mouse works meanwhile.</source>
        <translation>目前不能用该设备进行计分操作：%1。其间可用鼠标练习。</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Whether the haptic device of this station is fit for a graded run.</source>
        <translation>本工作站的力反馈设备是否可用于计分操作。</translation>
    </message>
    <message>
        <source>&amp;Check the device</source>
        <translation>检查设备(&amp;C)</translation>
    </message>
    <message>
        <source>the usual one</source>
        <translation>默认设备</translation>
    </message>
    <message>
        <source>&amp;Force test: somebody holds the stylus</source>
        <translation>力测试：有人握住手写笔(&amp;F)</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>What was looked at</source>
        <translation>检查项</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>发现</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>处理办法</translation>
    </message>
    <message>
        <source>Press Check the device.</source>
        <translation>请按“检查设备”。</translation>
    </message>
    <message>
        <source>Kept. It holds at this station from the next sign-in on</source>
        <translation>已保存。自下次登录起在本工作站生效</translation>
    </message>
    <message>
        <source>The device works. It gives no force: runs with it are graded only where the centre grades with the mouse.</source>
        <translation>设备工作正常。它不提供力：仅当中心允许用鼠标评分时，才会对用它进行的操作评分。</translation>
    </message>
    <message>
        <source>the first device that is there</source>
        <translation>第一个可用的设备</translation>
    </message>
    <message>
        <source>This station w&amp;orks with</source>
        <translation>本工作站使用(&amp;O)</translation>
    </message>
    <message>
        <source>De&amp;vice name</source>
        <translation>设备名称(&amp;V)</translation>
    </message>
</context>
<context>
    <name>torsio::gui::DiscrepancyReviewPage</name>
    <message>
        <source>Your mark stays as it is</source>
        <translation>您的评分保持不变</translation>
    </message>
    <message>
        <source>An adjudicator has been requested</source>
        <translation>已请求仲裁评分者</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>已保留</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>已修改</translation>
    </message>
    <message>
        <source>adjudicator requested</source>
        <translation>已请求仲裁</translation>
    </message>
    <message>
        <source>to be decided</source>
        <translation>待决定</translation>
    </message>
    <message>
        <source>Case %1</source>
        <translation>案例 %1</translation>
    </message>
    <message>
        <source>Decided. You may decide anew.</source>
        <translation>已决定，可重新决定。</translation>
    </message>
    <message>
        <source>Decided: %1</source>
        <translation>已决定：%1</translation>
    </message>
    <message>
        <source>Leave it unchanged</source>
        <translation>保持不变</translation>
    </message>
    <message>
        <source>&amp;Keep my mark</source>
        <translation>保留我的评分(&amp;K)</translation>
    </message>
    <message>
        <source>Discrepancy review</source>
        <translation>评分分歧复核</translation>
    </message>
    <message>
        <source>Only cases that all have submitted, and only where your mark differs from the others. The others are not named, nor are you to them.</source>
        <translation>仅列出所有人都已提交、且您的评分与他人差异较大的案例。他人不具名，您对他人也不具名。</translation>
    </message>
    <message>
        <source>No disagreement waits for you.</source>
        <translation>没有待处理的分歧。</translation>
    </message>
    <message>
        <source>Cases where your mark differs</source>
        <translation>您的评分差异较大的案例</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>案例</translation>
    </message>
    <message>
        <source>Apart by</source>
        <translation>相差</translation>
    </message>
    <message>
        <source>Decision</source>
        <translation>决定</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>Ask for an adjudica&amp;tor</source>
        <translation>请求仲裁评分者(&amp;T)</translation>
    </message>
    <message>
        <source>Look at it again</source>
        <translation>再看一遍</translation>
    </message>
    <message>
        <source>Diamond: you. Band: lowest to highest of the others. Line: their mean.</source>
        <translation>菱形：您。色带：他人最低至最高。竖线：他人均分。</translation>
    </message>
    <message>
        <source>Seal the moved mark</source>
        <translation>封存调整后的评分</translation>
    </message>
    <message>
        <source>The moved mark is sealed and flagged; the one before is kept</source>
        <translation>调整后的评分已封存并标记；原评分予以保留</translation>
    </message>
    <message>
        <source>Reason (needed to move a mark or to ask for an adjudicator)</source>
        <translation>理由（调整评分或请求仲裁评分者时必填）</translation>
    </message>
    <message>
        <source>&amp;Move with a reason…</source>
        <translation>说明理由并调整(&amp;M)…</translation>
    </message>
</context>
<context>
    <name>torsio::gui::EngineerPanel</name>
    <message>
        <source>The organ is built with this model: nothing can be recorded.</source>
        <translation>器官按此模型建立：不能录制。</translation>
    </message>
    <message>
        <source>The organ is built as its scene says.</source>
        <translation>器官按其场景的设定建立。</translation>
    </message>
    <message>
        <source>Model (engineer)</source>
        <translation>模型（工程师）</translation>
    </message>
    <message>
        <source>The parts of the twist model one by one</source>
        <translation>逐项设定扭转模型的各部分</translation>
    </message>
    <message>
        <source>For trying out the equations. Never part of a graded run.</source>
        <translation>用于试验各公式，绝不用于计分操作。</translation>
    </message>
    <message>
        <source>Shear modulus G</source>
        <translation>剪切模量 G</translation>
    </message>
    <message>
        <source> Pa</source>
        <translation> Pa</translation>
    </message>
    <message>
        <source>Drift (Eq. 16)</source>
        <translation>漂移项（式 16）</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>线性</translation>
    </message>
    <message>
        <source>constant, as printed</source>
        <translation>常数（论文原式）</translation>
    </message>
    <message>
        <source>Interpolation (Eq. 15)</source>
        <translation>插值（式 15）</translation>
    </message>
    <message>
        <source>the angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>dX, dY, dZ</source>
        <translation>dX、dY、dZ 分量</translation>
    </message>
    <message>
        <source>β in sections (Eq. 18)</source>
        <translation>β，以截面计（式 18）</translation>
    </message>
    <message>
        <source>infinite</source>
        <translation>无穷大</translation>
    </message>
    <message>
        <source>Lift clamp (Eq. 23)</source>
        <translation>夹持端抬升（式 23）</translation>
    </message>
    <message>
        <source>Poynting&apos;s stretch</source>
        <translation>Poynting 轴向伸长</translation>
    </message>
    <message>
        <source>Restrained ends</source>
        <translation>端部约束</translation>
    </message>
    <message>
        <source>Taper correction</source>
        <translation>锥度修正</translation>
    </message>
    <message>
        <source>About shear centres</source>
        <translation>绕剪切中心扭转</translation>
    </message>
    <message>
        <source>Foundation (organ lengths)</source>
        <translation>弹性地基（器官长度）</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Stiffening strain</source>
        <translation>硬化应变</translation>
    </message>
    <message>
        <source>App&amp;ly</source>
        <translation>应用(&amp;L)</translation>
    </message>
    <message>
        <source>As in the scene</source>
        <translation>恢复场景设定</translation>
    </message>
</context>
<context>
    <name>torsio::gui::EvaluationPage</name>
    <message>
        <source>Saved</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>Still open: %1 of %2</source>
        <translation>尚未填写：%2 项中的 %1 项</translation>
    </message>
    <message>
        <source>All nine are scored. Press again to seal them; sealed marks stay as they are.</source>
        <translation>九项均已评分。再按一次即封存，封存后不可更改。</translation>
    </message>
    <message>
        <source>Model %1 is submitted and sealed</source>
        <translation>模型 %1 已提交并封存</translation>
    </message>
    <message>
        <source>%1. Model %2, submitted</source>
        <translation>%1. 模型 %2，已提交</translation>
    </message>
    <message>
        <source>%1. Model %2</source>
        <translation>%1. 模型 %2</translation>
    </message>
    <message>
        <source>No evaluation asks for you at present.</source>
        <translation>目前没有需要您参加的评价。</translation>
    </message>
    <message>
        <source>%1: %2 to %3; keys 0 to 9 score, arrows left and right fine-tune, with Shift in steps of %4.</source>
        <translation>%1：%2 至 %3 分；数字键 0 至 9 评分，左右箭头微调，按住 Shift 时每步 %4。</translation>
    </message>
    <message>
        <source>All models are submitted. Thank you.</source>
        <translation>所有模型均已提交，谢谢。</translation>
    </message>
    <message>
        <source>Submitted and sealed</source>
        <translation>已提交并封存</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>模型评价</translation>
    </message>
    <message>
        <source>Submit this model</source>
        <translation>提交此模型</translation>
    </message>
    <message>
        <source>Ctrl+Enter</source>
        <translation>Ctrl+Enter</translation>
    </message>
    <message>
        <source>The recording is being opened. You may score meanwhile.</source>
        <translation>正在打开录制，您可以先评分。</translation>
    </message>
    <message>
        <source>Opening the recording of model %1</source>
        <translation>正在打开模型 %1 的录制</translation>
    </message>
    <message>
        <source>There is no recording of this model here: score what you have met at the station. An administrator can lay a recording down for each model.</source>
        <translation>此处没有该模型的录制：请按您在工作站上的体验评分。管理员可为每个模型配备录制。</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1。%2</translation>
    </message>
    <message>
        <source>Nine indices for each model, after each run. Which model stands behind a letter is hidden, and the order is your own.</source>
        <translation>每次操作后为每个模型评九项指标。字母对应的模型不公开，顺序因人而异。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ExerciseEditor</name>
    <message>
        <source>Title</source>
        <translation>标题</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>代码</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>器官</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>扭转</translation>
    </message>
    <message>
        <source>Counts as</source>
        <translation>性质</translation>
    </message>
    <message>
        <source>Target angle</source>
        <translation>目标角度</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>容差</translation>
    </message>
    <message>
        <source>Hold for</source>
        <translation>保持时间</translation>
    </message>
    <message>
        <source>Force up to</source>
        <translation>力上限</translation>
    </message>
    <message>
        <source>Torque up to</source>
        <translation>扭矩上限</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>尝试次数</translation>
    </message>
    <message>
        <source>Opens only after these are mastered</source>
        <translation>掌握以下练习后才开放</translation>
    </message>
    <message>
        <source>Mastered when all of these are reached</source>
        <translation>全部达到以下标准即为掌握</translation>
    </message>
    <message>
        <source>%1  (no such exercise any more)</source>
        <translation>%1（该练习已不存在）</translation>
    </message>
    <message>
        <source>An exercise needs a code; it keeps %1.</source>
        <translation>练习需要代码；保留 %1。</translation>
    </message>
    <message>
        <source>Another exercise has this code; this one keeps %1.</source>
        <translation>另一练习已使用此代码；本练习保留 %1。</translation>
    </message>
    <message>
        <source>New exercise</source>
        <translation>新练习</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>不限</translation>
    </message>
    <message>
        <source>practice</source>
        <translation>练习</translation>
    </message>
    <message>
        <source>graded</source>
        <translation>计分</translation>
    </message>
    <message>
        <source>Exercises, in their order</source>
        <translation>练习（按顺序）</translation>
    </message>
    <message>
        <source>Twists at least</source>
        <translation>最少扭转次数</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ExercisePanel</name>
    <message>
        <source>Exercise</source>
        <translation>练习</translation>
    </message>
    <message>
        <source>&amp;Organ</source>
        <translation>器官(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Pattern</source>
        <translation>扭转类型(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Model</source>
        <translation>模型(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Target</source>
        <translation>目标(&amp;T)</translation>
    </message>
    <message>
        <source>Saint-Venant</source>
        <translation>圣维南</translation>
    </message>
    <message>
        <source>As in the paper</source>
        <translation>按论文公式</translation>
    </message>
    <message>
        <source>Finite elements</source>
        <translation>有限元</translation>
    </message>
    <message>
        <source>Mass-spring lattice</source>
        <translation>质点弹簧点阵</translation>
    </message>
    <message>
        <source>Which model turns the organ and answers the hand</source>
        <translation>由哪个模型扭转器官并对手作出反馈</translation>
    </message>
    <message>
        <source>%1: no answer. The force of the grip is off</source>
        <translation>%1：没有应答，夹持力已关闭</translation>
    </message>
    <message>
        <source>%1: %2 times a second beside the force at %3</source>
        <translation>%1：每秒 %2 次，与每秒 %3 次的力并行</translation>
    </message>
    <message>
        <source>%1: beside the force; it begins with the first grip</source>
        <translation>%1：与力并行；自第一次夹持开始</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ExportDialog</name>
    <message>
        <source>&amp;Pseudonymised</source>
        <translation>假名化(&amp;P)</translation>
    </message>
    <message>
        <source>Keep what people &amp;wrote</source>
        <translation>保留人员填写的文字(&amp;W)</translation>
    </message>
    <message>
        <source>Export for other programs</source>
        <translation>导出供其他程序使用</translation>
    </message>
    <message>
        <source>Workbook for spreadsheets (.xlsx), with charts</source>
        <translation>电子表格工作簿（.xlsx），含图表</translation>
    </message>
    <message>
        <source>Tables for SPSS (.sav)</source>
        <translation>SPSS 数据表（.sav）</translation>
    </message>
    <message>
        <source>Tables for R (.csv and a script)</source>
        <translation>R 数据表（.csv 及脚本）</translation>
    </message>
    <message>
        <source>Tables (.csv)</source>
        <translation>数据表（.csv）</translation>
    </message>
    <message>
        <source>Scores for a learning system (Moodle, .csv)</source>
        <translation>学习系统成绩（Moodle，.csv）</translation>
    </message>
    <message>
        <source>For whom and what for; kept in the audit trail</source>
        <translation>供谁使用、作何用途；保存在审计记录中</translation>
    </message>
    <message>
        <source>First rows</source>
        <translation>前几行</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>格式(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Reason</source>
        <translation>原因(&amp;R)</translation>
    </message>
    <message>
        <source>What is in it</source>
        <translation>包含内容</translation>
    </message>
    <message>
        <source>First rows &amp;of</source>
        <translation>预览表格(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>保存(&amp;S)…</translation>
    </message>
    <message>
        <source>Reading what will be exported</source>
        <translation>正在读取要导出的数据</translation>
    </message>
    <message numerus="yes">
        <source>%1 (%n rows)</source>
        <translation>
            <numerusform>%1（%n 行）</numerusform>
        </translation>
    </message>
    <message>
        <source>A line for each trainee, known by staff number and mail address, and a score for each occasion. It names people.</source>
        <translation>每位学员一行，以工号和邮箱识别，每个评分时点一个得分。其中可识别人员身份。</translation>
    </message>
    <message>
        <source>Nobody is named. Marks and means that may not be shown yet are left out, as in the report.</source>
        <translation>不含人员姓名。尚不可显示的评分和平均值与报告中一样被略去。</translation>
    </message>
    <message>
        <source>Save workbook</source>
        <translation>保存工作簿</translation>
    </message>
    <message>
        <source>Workbook (*.xlsx)</source>
        <translation>工作簿 (*.xlsx)</translation>
    </message>
    <message>
        <source>Save scores</source>
        <translation>保存成绩</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>New folder for the tables</source>
        <translation>存放表格的新文件夹</translation>
    </message>
    <message>
        <source>tables-%1</source>
        <translation>表格-%1</translation>
    </message>
    <message>
        <source>Folder (*)</source>
        <translation>文件夹 (*)</translation>
    </message>
    <message>
        <source>Writing the export</source>
        <translation>正在写入导出文件</translation>
    </message>
    <message numerus="yes">
        <source>Written: %1 (%n files). Hash: %2</source>
        <translation>
            <numerusform>已写入：%1（%n 个文件）。哈希值：%2</numerusform>
        </translation>
    </message>
    <message>
        <source>Data set to be published (Frictionless)</source>
        <translation>供发布的数据集（Frictionless）</translation>
    </message>
    <message>
        <source>Data set to be published (RO-Crate)</source>
        <translation>供发布的数据集（RO-Crate）</translation>
    </message>
    <message>
        <source>Data set to be published (BIDS)</source>
        <translation>供发布的数据集（BIDS）</translation>
    </message>
    <message>
        <source>How users cite the data; may be empty</source>
        <translation>使用者如何引用；可留空</translation>
    </message>
    <message>
        <source>Person or centre that publishes; may be empty</source>
        <translation>发布的个人或中心；可留空</translation>
    </message>
    <message>
        <source>%1 lines a second</source>
        <translation>每秒 %1 行</translation>
    </message>
    <message>
        <source>&amp;Title</source>
        <translation>标题(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Licence (SPDX)</source>
        <translation>许可证（SPDX）(&amp;L)</translation>
    </message>
    <message>
        <source>C&amp;itation</source>
        <translation>引用方式(&amp;I)</translation>
    </message>
    <message>
        <source>Publis&amp;her</source>
        <translation>发布者(&amp;H)</translation>
    </message>
    <message>
        <source>Tra&amp;jectories</source>
        <translation>轨迹(&amp;J)</translation>
    </message>
    <message numerus="yes">
        <source>The tables below, the paths and forces of %n recordings, parameters of the tissue models, curriculum and definitions of metrics, in a new folder. No recordings that Torsio could replay.</source>
        <translation>
            <numerusform>下列表格、%n 个录制的路径与力、组织模型参数、课程与指标定义，写入新文件夹。不含 Torsio 可重放的录制。</numerusform>
        </translation>
    </message>
    <message>
        <source>Paths tell how somebody moves: publish them only with consent for that.</source>
        <translation>路径反映一个人的动作方式：须获得相应同意方可发布。</translation>
    </message>
    <message>
        <source>New folder for the data set</source>
        <translation>数据集的新文件夹</translation>
    </message>
    <message>
        <source>dataset-%1</source>
        <translation>dataset-%1</translation>
    </message>
</context>
<context>
    <name>torsio::gui::FigureCanvas</name>
    <message numerus="yes">
        <source>%n row(s) more in the table</source>
        <translation>
            <numerusform>表中还有 %n 行</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::FigureCard</name>
    <message>
        <source>Copies the picture and its table (Ctrl+C)</source>
        <translation>复制图形及其数据表（Ctrl+C）</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>图形</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
</context>
<context>
    <name>torsio::gui::FirstRunPanel</name>
    <message>
        <source>Database file</source>
        <translation>数据库文件</translation>
    </message>
    <message>
        <source>Torsio databases (*.sqlite)</source>
        <translation>Torsio 数据库 (*.sqlite)</translation>
    </message>
    <message>
        <source>A centre keeps its records there already. You can sign in to it after this step</source>
        <translation>该数据库已有中心在使用，完成此步骤后即可登录</translation>
    </message>
    <message>
        <source>The database answers and is empty: it can be used</source>
        <translation>数据库连接正常且为空，可以使用</translation>
    </message>
    <message>
        <source>Enter the name of your centre</source>
        <translation>请输入中心名称</translation>
    </message>
    <message>
        <source>Enter a sign-in name</source>
        <translation>请输入登录名</translation>
    </message>
    <message>
        <source>The two passwords are not the same</source>
        <translation>两次输入的密码不一致</translation>
    </message>
    <message>
        <source>Say where the database is</source>
        <translation>请指定数据库位置</translation>
    </message>
    <message>
        <source>Sign-in name</source>
        <translation>登录名</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>角色</translation>
    </message>
    <message>
        <source>Start password</source>
        <translation>初始密码</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>学员</translation>
    </message>
    <message>
        <source>Physician who scores</source>
        <translation>评分医师</translation>
    </message>
    <message>
        <source>Welcome to Torsio</source>
        <translation>欢迎使用 Torsio</translation>
    </message>
    <message>
        <source>The first administrator</source>
        <translation>首位管理员</translation>
    </message>
    <message>
        <source>Where records are kept</source>
        <translation>记录保存位置</translation>
    </message>
    <message>
        <source>Something to try it with</source>
        <translation>试用内容</translation>
    </message>
    <message>
        <source>Accounts of the demonstration</source>
        <translation>演示账户</translation>
    </message>
    <message>
        <source>Four short steps set up your centre. Nothing is written before the last one.</source>
        <translation>只需四个简短步骤即可建立您的中心。最后一步之前不会写入任何内容。</translation>
    </message>
    <message>
        <source>This person lets others in. There is no default password; choose one of at least fifteen characters, a short sentence for example.</source>
        <translation>管理员为其他人开通账户。没有默认密码；请设置至少十五个字符的密码，例如一个短句。</translation>
    </message>
    <message>
        <source>One computer, or a server that several stations share.</source>
        <translation>单台计算机，或多个工作站共用的服务器。</translation>
    </message>
    <message>
        <source>A demonstration cohort shows every screen with content: 30 simulated trainees, ten physicians, 900 marks.</source>
        <translation>演示批次让每个页面都有内容：30 名模拟学员、10 名医师、900 个评分。</translation>
    </message>
    <message>
        <source>These start passwords are shown only now. Each must be changed at the first sign-in.</source>
        <translation>初始密码只在此处显示一次，首次登录时必须修改。</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>第 %1 步，共 %2 步</translation>
    </message>
    <message>
        <source>&amp;Name of the centre</source>
        <translation>中心名称(&amp;N)</translation>
    </message>
    <message>
        <source>Skills laboratory, city hospital</source>
        <translation>市医院技能培训中心</translation>
    </message>
    <message>
        <source>Sign-in &amp;name</source>
        <translation>登录名(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Password</source>
        <translation>密码(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Begin empty</source>
        <translation>从空白开始(&amp;B)</translation>
    </message>
    <message>
        <source>People, curricula and cohorts are entered or imported.</source>
        <translation>人员、课程和班级由您录入或导入。</translation>
    </message>
    <message>
        <source>With a &amp;demonstration cohort</source>
        <translation>包含演示批次(&amp;D)</translation>
    </message>
    <message>
        <source>Takes less than a minute. Every row is marked as a demonstration; it can be removed with one click.</source>
        <translation>用时不到一分钟。每一行都标记为演示数据；可一键删除。</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>上一步</translation>
    </message>
    <message>
        <source>I have noted them</source>
        <translation>我已记下</translation>
    </message>
    <message>
        <source>Set up</source>
        <translation>完成设置</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>A &amp;file on this computer</source>
        <translation>本机上的文件(&amp;F)</translation>
    </message>
    <message>
        <source>For one station. Not on a network drive: such files are damaged there.</source>
        <translation>适用于单个工作站。不要放在网络驱动器上，否则文件会损坏。</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>A Postgre&amp;SQL server</source>
        <translation>PostgreSQL 服务器(&amp;S)</translation>
    </message>
    <message>
        <source>For several stations. Keep the password in the server account&apos;s password file (.pgpass), not in this line.</source>
        <translation>适用于多个工作站。密码请保存在账户的密码文件 (.pgpass) 中，不要写在此行。</translation>
    </message>
    <message>
        <source>Address of the server</source>
        <translation>服务器地址</translation>
    </message>
    <message>
        <source>&amp;Test the database</source>
        <translation>测试数据库(&amp;T)</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>语言(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Look round with simulated people</source>
        <translation>用模拟人员浏览(&amp;L)</translation>
    </message>
    <message>
        <source>Needs no password. Everything lies in a folder of its own, which is removed when you sign out.</source>
        <translation>无需密码。全部内容位于单独的文件夹中，退出登录时即删除。</translation>
    </message>
    <message>
        <source>Repeat p&amp;assword</source>
        <translation>重复密码(&amp;A)</translation>
    </message>
</context>
<context>
    <name>torsio::gui::FoldLine</name>
    <message>
        <source>Hide</source>
        <translation>收起</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>展开</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>torsio::gui::GroupEditor</name>
    <message>
        <source>Name of the group</source>
        <translation>组名</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>代码</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>休息</translation>
    </message>
    <message>
        <source>Phases, one after the other</source>
        <translation>阶段（依次进行）</translation>
    </message>
    <message>
        <source>any exercise</source>
        <translation>任意练习</translation>
    </message>
    <message>
        <source>Where phase %1 happens</source>
        <translation>第 %1 阶段的地点</translation>
    </message>
    <message>
        <source>Name of phase %1</source>
        <translation>第 %1 阶段的名称</translation>
    </message>
    <message>
        <source>Minutes of phase %1</source>
        <translation>第 %1 阶段的分钟数</translation>
    </message>
    <message>
        <source>Exercise of phase %1</source>
        <translation>第 %1 阶段的练习</translation>
    </message>
    <message>
        <source>A group needs a code; it keeps %1.</source>
        <translation>组别需要代码；保留 %1。</translation>
    </message>
    <message>
        <source>Another group has this code; this one keeps %1.</source>
        <translation>另一组已使用此代码；本组保留 %1。</translation>
    </message>
    <message>
        <source>New group</source>
        <translation>新组别</translation>
    </message>
    <message>
        <source>New phase</source>
        <translation>新阶段</translation>
    </message>
    <message>
        <source> min</source>
        <translation> 分钟</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>may be taken in parts</source>
        <translation>可分次进行</translation>
    </message>
    <message>
        <source>Groups, in their order</source>
        <translation>组别（按顺序）</translation>
    </message>
    <message>
        <source>Add phase</source>
        <translation>添加阶段</translation>
    </message>
    <message>
        <source>Remove phase</source>
        <translation>删除阶段</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>提前</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>推后</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>地点</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Minutes</source>
        <translation>分钟</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>练习</translation>
    </message>
    <message>
        <source>In all %1 min of training: %2 on the simulator, %3 on the real arm. Rest does not count.</source>
        <translation>训练共 %1 分钟：模拟器 %2 分钟，实物手臂 %3 分钟。休息不计。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::HeadNotice</name>
    <message>
        <source>Copied</source>
        <translation>已复制</translation>
    </message>
    <message>
        <source>Head of the audit trail</source>
        <translation>审计记录的链头</translation>
    </message>
    <message>
        <source>%1 entries, %2 UTC, %3</source>
        <translation>共 %1 条记录，%2 UTC，%3</translation>
    </message>
    <message>
        <source>signed</source>
        <translation>已签名</translation>
    </message>
    <message>
        <source>not signed</source>
        <translation>未签名</translation>
    </message>
    <message>
        <source>Hash of the newest entry: %1</source>
        <translation>最新记录的哈希：%1</translation>
    </message>
    <message>
        <source>The head was not kept. %1</source>
        <translation>链头未能保存。%1</translation>
    </message>
    <message>
        <source>This station keeps no heads. Copy it or write it down, away from the record: with it anybody can tell later whether the trail was cut off or rewritten.</source>
        <translation>本站不保存链头。请复制或抄下，并与数据分开存放：日后凭它可以查出审计记录是否被截断或改写。</translation>
    </message>
    <message>
        <source>&amp;Copy the head</source>
        <translation>复制链头(&amp;C)</translation>
    </message>
    <message>
        <source>It was added to the witness file of this station: %1</source>
        <translation>已添加到本站的见证文件：%1</translation>
    </message>
</context>
<context>
    <name>torsio::gui::HeadsPage</name>
    <message>
        <source>Heads are signed with the key in %1
Its public part, to be kept where heads are checked: %2</source>
        <translation>链头用此文件中的密钥签名：%1
其公钥请保存在核对链头的地方：%2</translation>
    </message>
    <message>
        <source>! The key lies beside the record: whoever takes the folder can sign. Move it away.</source>
        <translation>! 密钥与记录放在同一文件夹：拿到该文件夹的人就能签名。请将它移走。</translation>
    </message>
    <message>
        <source>! This station has no key, so its heads are not signed: whoever can change the place where they are kept can replace them.</source>
        <translation>! 本站没有密钥，链头未签名：能改动其保存位置的人就能替换它们。</translation>
    </message>
    <message>
        <source>&amp;Make a key…</source>
        <translation>生成密钥(&amp;M)…</translation>
    </message>
    <message>
        <source>&amp;Replace the key…</source>
        <translation>更换密钥(&amp;R)…</translation>
    </message>
    <message>
        <source>Each sign-out of an administrator adds a head to %1. Lines now: %2</source>
        <translation>管理员每次退出登录时，都会在 %1 中添加一个链头。现有行数：%2</translation>
    </message>
    <message>
        <source>! It lies on the disk of the record: whoever takes the disk, or puts an older one back, has both. Choose a file on another disk.</source>
        <translation>! 它与记录在同一磁盘上：拿走该磁盘或换回旧磁盘的人同时拥有两者。请选择另一磁盘上的文件。</translation>
    </message>
    <message>
        <source>! This station keeps no heads. A record that was cut off, rewritten or put back is not found by itself.</source>
        <translation>! 本站不保存链头。记录若被截断、重写或换成旧的，无法自行发现。</translation>
    </message>
    <message>
        <source>The key is made. Note its public part elsewhere</source>
        <translation>密钥已生成。请在别处记下其公钥</translation>
    </message>
    <message>
        <source>Make a key in a new file</source>
        <translation>在新文件中生成密钥</translation>
    </message>
    <message>
        <source>Key (*)</source>
        <translation>密钥 (*)</translation>
    </message>
    <message>
        <source>Choose the file of a key</source>
        <translation>选择密钥文件</translation>
    </message>
    <message>
        <source>Keep heads in a file on another disk</source>
        <translation>将链头保存到另一磁盘上的文件</translation>
    </message>
    <message>
        <source>Heads (*)</source>
        <translation>链头 (*)</translation>
    </message>
    <message>
        <source>The head was added to the witness file</source>
        <translation>链头已添加到见证文件</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>已复制</translation>
    </message>
    <message>
        <source>Head of the audit trail, printed at %1</source>
        <translation>审计记录的链头，打印于 %1</translation>
    </message>
    <message>
        <source>Heads that were kept</source>
        <translation>已保存的链头</translation>
    </message>
    <message>
        <source>Comparing the record with kept heads</source>
        <translation>正在将记录与已保存的链头核对</translation>
    </message>
    <message>
        <source>✓ The audit trail is the one that these heads were taken from, and nothing was cut off.</source>
        <translation>✓ 审计记录正是取得这些链头时的那一份，没有内容被截断。</translation>
    </message>
    <message numerus="yes">
        <source>⚠ %n finding(s). Do not report from this record before they are explained.</source>
        <translation>
            <numerusform>⚠ 发现 %n 处异常。在查明之前，请勿据此记录出具报告。</numerusform>
        </translation>
    </message>
    <message>
        <source>• entry %1: %2</source>
        <translation>• 条目 %1：%2</translation>
    </message>
    <message>
        <source>Heads of the audit trail</source>
        <translation>审计记录的链头</translation>
    </message>
    <message>
        <source>What is kept outside of the record, and finds what the record cannot tell of itself: entries cut off, a trail rewritten, an older file put back.</source>
        <translation>保存在记录之外，用来发现记录本身看不出的改动：条目被截断、审计记录被重写、换回旧文件。</translation>
    </message>
    <message>
        <source>&amp;Back to the audit trail</source>
        <translation>返回审计记录(&amp;B)</translation>
    </message>
    <message>
        <source>This station</source>
        <translation>本站</translation>
    </message>
    <message>
        <source>&amp;Use another key…</source>
        <translation>使用另一密钥(&amp;U)…</translation>
    </message>
    <message>
        <source>Choose the &amp;witness file…</source>
        <translation>选择见证文件(&amp;W)…</translation>
    </message>
    <message>
        <source>Keep &amp;no heads</source>
        <translation>不保存链头(&amp;N)</translation>
    </message>
    <message>
        <source>The head now</source>
        <translation>当前链头</translation>
    </message>
    <message>
        <source>Length, hash and time of the trail in one line. Keep it where nobody who can change the record can change it: on paper, in a mail, on another disk.</source>
        <translation>一行中包含审计记录的长度、哈希值和时间。请保存在能改动记录的人无法改动的地方：纸上、邮件中、另一磁盘上。</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Print…</source>
        <translation>打印(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Add to the witness file</source>
        <translation>添加到见证文件(&amp;A)</translation>
    </message>
    <message>
        <source>Compare with heads that were kept</source>
        <translation>与已保存的链头核对</translation>
    </message>
    <message>
        <source>Paste or type heads, one a line, or read a witness file. Without a public key they must be signed with the key of this station, where it has one.</source>
        <translation>粘贴或输入链头，每行一个，或读取见证文件。未填公钥时，若本站有密钥，链头须由本站的密钥签名。</translation>
    </message>
    <message>
        <source>Read a &amp;file…</source>
        <translation>读取文件(&amp;F)…</translation>
    </message>
    <message>
        <source>Public &amp;key</source>
        <translation>公钥(&amp;K)</translation>
    </message>
    <message>
        <source>that of this station</source>
        <translation>本站的公钥</translation>
    </message>
    <message>
        <source>&amp;Verify</source>
        <translation>验证(&amp;V)</translation>
    </message>
    <message>
        <source>Paste at least one head, or read a file.</source>
        <translation>请至少粘贴一个链头，或读取文件。</translation>
    </message>
    <message>
        <source>A public key has 64 digits, 0 to 9 and a to f; this one has %1 characters.</source>
        <translation>公钥为 64 位（0 至 9、a 至 f）；此处有 %1 个字符。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::InvitationsDialog</name>
    <message>
        <source>Invitations</source>
        <translation>登录邀请</translation>
    </message>
    <message>
        <source>Links and codes are shown only now. Each is for one person, and a link is good once and for a week. A code goes to its person by another way than the link that another administrator hands over.</source>
        <translation>链接和代码只在此时显示。每项只供一人使用，链接限用一次，一周内有效。代码应通过与链接不同的途径交给本人，链接由另一位管理员转交。</translation>
    </message>
    <message>
        <source>invitations.pdf</source>
        <translation>登录邀请.pdf</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>人员</translation>
    </message>
    <message>
        <source>Sign-in name</source>
        <translation>登录名</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>链接</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>代码</translation>
    </message>
    <message>
        <source>For %1:</source>
        <translation>致 %1：</translation>
    </message>
</context>
<context>
    <name>torsio::gui::JobPanel</name>
    <message>
        <source>%1 min left</source>
        <translation>剩余 %1 分钟</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>正在停止…</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 %, %2</source>
        <translation>%1 %，%2</translation>
    </message>
    <message>
        <source>Work in progress</source>
        <translation>任务进行中</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>剩余 %1</translation>
    </message>
</context>
<context>
    <name>torsio::gui::KioskCardsDialog</name>
    <message>
        <source>Cards for the kiosk</source>
        <translation>自助终端卡片</translation>
    </message>
    <message>
        <source>These codes are shown only now. Each opens a kiosk for its trainee; one that is lost is revoked here, or replaced by making a new one.</source>
        <translation>这些代码仅显示这一次。每个代码供其学员在自助终端登录；丢失的卡片可在此撤销，或通过生成新卡片替换。</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>人员</translation>
    </message>
    <message>
        <source>Sign-in name</source>
        <translation>登录名</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>代码</translation>
    </message>
    <message>
        <source>kiosk-cards.pdf</source>
        <translation>自助终端卡片.pdf</translation>
    </message>
</context>
<context>
    <name>torsio::gui::LearningRecordsDialog</name>
    <message>
        <source>Send learning &amp;records (xAPI)</source>
        <translation>发送学习记录(xAPI)(&amp;R)</translation>
    </message>
    <message>
        <source>Send &amp;now</source>
        <translation>立即发送(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Try all again</source>
        <translation>全部重试(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Give up the refused</source>
        <translation>放弃被拒绝的记录(&amp;G)</translation>
    </message>
    <message>
        <source>Learning records</source>
        <translation>学习记录</translation>
    </message>
    <message>
        <source>The learning system of the centre hears of enrolments, runs, passes and failures, rests and remarks that were read, under opaque accounts, of trainees who have agreed to it. What happened before this was turned on is not told.</source>
        <translation>中心的学习系统会收到已同意的学员的登记、练习、通过与未通过、休息和已读评语，均以匿名账户表示。开启之前发生的事情不会发送。</translation>
    </message>
    <message>
        <source>&amp;Address of the learning record store</source>
        <translation>学习记录库地址(&amp;A)</translation>
    </message>
    <message>
        <source>Home &amp;page of the accounts</source>
        <translation>账户所属主页(&amp;P)</translation>
    </message>
    <message>
        <source>Set the &amp;key</source>
        <translation>设置密钥(&amp;K)</translation>
    </message>
    <message>
        <source>name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>secret</source>
        <translation>密码</translation>
    </message>
    <message>
        <source>Name of the key</source>
        <translation>密钥名称</translation>
    </message>
    <message>
        <source>Secret of the key</source>
        <translation>密钥密码</translation>
    </message>
    <message>
        <source>Key of this station</source>
        <translation>此工作站的密钥</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>When</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Tries</source>
        <translation>尝试次数</translation>
    </message>
    <message>
        <source>What the store said</source>
        <translation>学习记录库的答复</translation>
    </message>
    <message>
        <source>Nothing was refused.</source>
        <translation>没有被拒绝的记录。</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>关闭(&amp;L)</translation>
    </message>
    <message>
        <source>This station has a key and sends. The key lies in a file of this account, never in the record.</source>
        <translation>此工作站有密钥并负责发送。密钥保存在此账户的文件中，绝不写入数据库。</translation>
    </message>
    <message>
        <source>This station has no key and sends nothing. One station with a key is enough.</source>
        <translation>此工作站没有密钥，不发送任何内容。有一台带密钥的工作站即可。</translation>
    </message>
    <message>
        <source>Waiting: %1, delivered: %2, refused for good: %3</source>
        <translation>等待：%1，已送达：%2，被彻底拒绝：%3</translation>
    </message>
    <message>
        <source>! What waits was not taken: %1</source>
        <translation>! 等待中的记录未被接收：%1</translation>
    </message>
    <message>
        <source>Kept. What happens from now on is sent</source>
        <translation>已保存。今后发生的事情将被发送</translation>
    </message>
    <message>
        <source>Kept. Nothing is sent</source>
        <translation>已保存。不发送任何内容</translation>
    </message>
    <message>
        <source>Sending learning records</source>
        <translation>正在发送学习记录</translation>
    </message>
</context>
<context>
    <name>torsio::gui::LevelBar</name>
    <message>
        <source>%1, at the limit</source>
        <translation>%1，已达上限</translation>
    </message>
    <message>
        <source>at limit  %1</source>
        <translation>已达上限  %1</translation>
    </message>
</context>
<context>
    <name>torsio::gui::LivePage</name>
    <message>
        <source>The timer is running. Stop it first</source>
        <translation>计时器正在运行，请先停止</translation>
    </message>
    <message>
        <source>submitted</source>
        <translation>已提交</translation>
    </message>
    <message>
        <source>%1.  Case %2, %3</source>
        <translation>%1.  案例 %2，%3</translation>
    </message>
    <message>
        <source>Hide earlier ones</source>
        <translation>隐藏先前的</translation>
    </message>
    <message>
        <source>Show earlier ones (%1)</source>
        <translation>显示先前的（%1）</translation>
    </message>
    <message>
        <source>Saved on this machine</source>
        <translation>已保存在本机</translation>
    </message>
    <message>
        <source>Saved on the centre&apos;s server</source>
        <translation>已保存在中心服务器</translation>
    </message>
    <message>
        <source>Time taken: %1</source>
        <translation>用时：%1</translation>
    </message>
    <message>
        <source>Still open: %1</source>
        <translation>尚未填写：%1</translation>
    </message>
    <message>
        <source>All rows have the same mark. Press again to seal the sheet.</source>
        <translation>各项评分完全相同。再按一次即封存。</translation>
    </message>
    <message>
        <source>The rows lie far apart. Press again to seal the sheet.</source>
        <translation>各项分数相差很大。再按一次即封存评分表。</translation>
    </message>
    <message>
        <source>Everything is scored. Press again to seal the sheet.</source>
        <translation>已全部评分。再按一次即封存。</translation>
    </message>
    <message>
        <source>Case %1 is submitted and sealed</source>
        <translation>案例 %1 已提交并封存</translation>
    </message>
    <message>
        <source>Case %1</source>
        <translation>案例 %1</translation>
    </message>
    <message>
        <source>Stop the timer</source>
        <translation>停止计时</translation>
    </message>
    <message>
        <source>Start the timer</source>
        <translation>开始计时</translation>
    </message>
    <message>
        <source>Submitted and sealed</source>
        <translation>已提交并封存</translation>
    </message>
    <message>
        <source>Live sheet</source>
        <translation>现场评分表</translation>
    </message>
    <message>
        <source>Makes a new version with a reason; the submitted one is kept</source>
        <translation>附理由生成新版本；已提交的版本保留</translation>
    </message>
    <message>
        <source>Note the time</source>
        <translation>记录用时</translation>
    </message>
    <message>
        <source>Submit</source>
        <translation>提交</translation>
    </message>
    <message>
        <source>Timer</source>
        <translation>计时器</translation>
    </message>
    <message>
        <source>Start or stop the timer</source>
        <translation>启动或停止计时</translation>
    </message>
    <message>
        <source>Not assessable: type why, Enter</source>
        <translation>无法评定：输入原因，回车</translation>
    </message>
    <message>
        <source>Case %1 is called now. What you have begun here is kept: submit it, or choose the case at the left and come back later.</source>
        <translation>现在呼叫的是案例 %1。您在此处已填写的内容会保留：请提交，或在左侧选择该案例，稍后再回来。</translation>
    </message>
    <message>
        <source>draft, called now</source>
        <translation>草稿，呼叫中</translation>
    </message>
    <message>
        <source>draft, late</source>
        <translation>草稿，逾期</translation>
    </message>
    <message>
        <source>called now</source>
        <translation>呼叫中</translation>
    </message>
    <message>
        <source>late</source>
        <translation>逾期</translation>
    </message>
    <message>
        <source>Nobody is called yet</source>
        <translation>尚未呼叫任何人</translation>
    </message>
    <message>
        <source>The sheet opens by itself when the office calls a case.</source>
        <translation>管理员呼叫案例后，评分表会自动打开。</translation>
    </message>
    <message>
        <source>Real arm: the sheet follows the call. Works without a network; every tap is saved.</source>
        <translation>实物手臂：评分表随呼叫切换。无需网络；每次点按均会保存。</translation>
    </message>
    <message>
        <source>Real arm: the sheet follows the call. Every tap is saved on the centre&apos;s server; if it cannot be reached, it is said at once.</source>
        <translation>实物手臂：评分表随呼叫切换。每次点按均保存到中心服务器；无法连接时会立即提示。</translation>
    </message>
    <message>
        <source>Case %1 is called to %2: if you are there, choose it at the left.</source>
        <translation>案例 %1 已被呼叫到 %2：如果您在那里，请在左侧选择它。</translation>
    </message>
    <message>
        <source>&amp;Amend…</source>
        <translation>更正(&amp;A)…</translation>
    </message>
    <message>
        <source>The overall mark lies outside the rows. Press again to seal the sheet.</source>
        <translation>总分超出各行分数的范围。再按一次即封存评分表。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::LockPanel</name>
    <message>
        <source>Locked</source>
        <translation>已锁定</translation>
    </message>
    <message>
        <source>%1 is signed in here. Nothing was lost; the work goes on where it was left.</source>
        <translation>%1 已在此登录。内容没有丢失，解锁后可继续。</translation>
    </message>
    <message>
        <source>&amp;Password</source>
        <translation>密码(&amp;P)</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>解锁</translation>
    </message>
    <message>
        <source>Sign out</source>
        <translation>退出登录</translation>
    </message>
</context>
<context>
    <name>torsio::gui::MainWindow</name>
    <message>
        <source>Something is unfinished here. Only its owner can sign out</source>
        <translation>此处有未完成的内容，只有本人可以退出登录</translation>
    </message>
    <message>
        <source>You were signed out because nobody was here</source>
        <translation>由于长时间无人操作，已退出登录</translation>
    </message>
    <message>
        <source>The database does not answer. Your run goes on; it is kept on this computer and stored as soon as the database answers</source>
        <translation>数据库没有应答。您的操作继续进行；录制保存在本机，数据库恢复后立即存入</translation>
    </message>
    <message>
        <source>The database does not answer. Torsio tries again by itself; what is stored is safe</source>
        <translation>数据库没有应答。Torsio 会自动重试；已存入的数据是安全的</translation>
    </message>
    <message>
        <source>Warning of the idle lock</source>
        <translation>无操作锁定提醒</translation>
    </message>
    <message>
        <source>State of the database</source>
        <translation>数据库状态</translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) of this station could not be stored</source>
        <translation>
            <numerusform>本工作站有 %n 份记录未能存入数据库</numerusform>
        </translation>
    </message>
    <message>
        <source>The files are kept. Please show this to your administrator</source>
        <translation>文件已保留，请将此信息告知管理员</translation>
    </message>
    <message>
        <source>PIN for practice</source>
        <translation>练习用 PIN 码</translation>
    </message>
    <message>
        <source>At least four digits. With it you practise at a station; nothing is recorded.
Leave it empty to remove it.</source>
        <translation>至少四位数字。可用它在工作站练习，不作任何记录。
留空则删除。</translation>
    </message>
    <message>
        <source>The PIN was removed</source>
        <translation>PIN 码已删除</translation>
    </message>
    <message>
        <source>The PIN is in force</source>
        <translation>PIN 码已生效</translation>
    </message>
    <message>
        <source>There is no demonstration data</source>
        <translation>没有演示数据</translation>
    </message>
    <message>
        <source>Remove demonstration data</source>
        <translation>删除演示数据</translation>
    </message>
    <message>
        <source>Your own data stay as they are. This cannot be undone.</source>
        <translation>您自己的数据不受影响。此操作无法撤销。</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Removing the demonstration</source>
        <translation>正在删除演示数据</translation>
    </message>
    <message>
        <source>Removed from the user menu</source>
        <translation>通过用户菜单删除</translation>
    </message>
    <message>
        <source>The demonstration data were removed</source>
        <translation>演示数据已删除</translation>
    </message>
    <message>
        <source>Leave kiosk mode</source>
        <translation>退出自助终端模式</translation>
    </message>
    <message>
        <source>An administrator ends the kiosk with name and password.</source>
        <translation>管理员可用登录名和密码结束自助终端模式。</translation>
    </message>
    <message>
        <source>Only an administrator can end the kiosk</source>
        <translation>只有管理员可以结束自助终端模式</translation>
    </message>
    <message>
        <source>The database answers again, and what was kept meanwhile is stored</source>
        <translation>数据库已恢复应答，期间保存的内容已存入</translation>
    </message>
    <message>
        <source>Leave the password out of the address; it would stand in a settings file. Put it into .pgpass</source>
        <translation>请不要在地址中写密码，否则它会保存在设置文件里。请写入 .pgpass</translation>
    </message>
    <message>
        <source>Setting up the centre</source>
        <translation>正在设置中心</translation>
    </message>
    <message>
        <source>Cancelled; nothing was set up</source>
        <translation>已取消；未建立任何内容</translation>
    </message>
    <message>
        <source>Name and password do not fit together. Please try again</source>
        <translation>登录名与密码不匹配，请重试</translation>
    </message>
    <message>
        <source>This account is switched off. Ask your administrator</source>
        <translation>该账户已停用，请联系管理员</translation>
    </message>
    <message>
        <source>The new password is in force</source>
        <translation>新密码已生效</translation>
    </message>
    <message>
        <source>That is not the password. Please try again</source>
        <translation>密码不正确，请重试</translation>
    </message>
    <message>
        <source>%1. Waiting to be stored: %2</source>
        <translation>%1。等待保存：%2 项</translation>
    </message>
    <message>
        <source>The head of the audit trail was not kept: %1</source>
        <translation>未能保存审计记录的链头：%1</translation>
    </message>
    <message numerus="yes">
        <source>The database refused %n entries of this station for good. Please tell whoever looks after it</source>
        <translation>
            <numerusform>数据库最终拒绝了本工作站的 %n 条记录。请告知维护人员</numerusform>
        </translation>
    </message>
    <message>
        <source>Remove the simulated people (%1), their runs (%2) and marks (%3)?</source>
        <translation>删除模拟人员（%1）、其操作（%2）和评分（%3）？</translation>
    </message>
    <message>
        <source>No folder can be made for it: %1</source>
        <translation>无法为此创建文件夹：%1</translation>
    </message>
    <message>
        <source>A look round: simulated people</source>
        <translation>浏览：模拟人员</translation>
    </message>
    <message>
        <source>Everybody here is simulated. Sign out, and all of it is gone</source>
        <translation>此处所有人员均为模拟。退出登录后全部删除</translation>
    </message>
    <message>
        <source>You are a simulated trainee. Sign out to become yourself again</source>
        <translation>您现在是模拟学员。退出登录即可恢复自己的身份</translation>
    </message>
    <message>
        <source>No card with this code is in force. Sign in with your name and password</source>
        <translation>没有使用此代码的有效卡片。请用登录名和密码登录</translation>
    </message>
    <message>
        <source>Close the window once more, when you have read this</source>
        <translation>阅读后请再次关闭窗口</translation>
    </message>
    <message>
        <source>Nobody here? You will be signed out in %1. Press any key to stay</source>
        <translation>没有人在吗？%1 后将退出登录。按任意键继续</translation>
    </message>
    <message>
        <source>Nobody here? The screen will be locked in %1. Press any key to stay</source>
        <translation>没有人在吗？%1 后将锁定屏幕。按任意键继续</translation>
    </message>
    <message>
        <source>Too many wrong tries. Please wait %1</source>
        <translation>错误次数过多，请等待 %1</translation>
    </message>
</context>
<context>
    <name>torsio::gui::MaintenancePage</name>
    <message>
        <source>%1, %2 free on the disk</source>
        <translation>%1，磁盘剩余 %2</translation>
    </message>
    <message>
        <source>Disk in use</source>
        <translation>磁盘用量</translation>
    </message>
    <message>
        <source>On a database server</source>
        <translation>位于数据库服务器</translation>
    </message>
    <message>
        <source>There are no simulated people in this record.</source>
        <translation>记录中没有模拟人员。</translation>
    </message>
    <message>
        <source>A backup takes the place of this record, or the record goes to a database server for several stations. Both ask first and show what they will do.</source>
        <translation>用备份取代此记录，或将记录迁移到供多个工作站使用的数据库服务器。两者都会先询问并说明将要执行的操作。</translation>
    </message>
    <message>
        <source>This record lies on a database server. Its administrator backs it up and restores it with the server&apos;s own tools.</source>
        <translation>此记录位于数据库服务器上，由服务器管理员用服务器自带的工具备份和恢复。</translation>
    </message>
    <message>
        <source>Backing up</source>
        <translation>正在备份</translation>
    </message>
    <message>
        <source>Testing a backup</source>
        <translation>正在测试备份</translation>
    </message>
    <message>
        <source>✗ This backup is not sound. Make a new one.
%1</source>
        <translation>✗ 该备份不完好，请重新备份。
%1</translation>
    </message>
    <message>
        <source>Checking the database</source>
        <translation>正在检查数据库</translation>
    </message>
    <message>
        <source>Back up to</source>
        <translation>备份到</translation>
    </message>
    <message>
        <source>Backup (*.sqlite)</source>
        <translation>备份 (*.sqlite)</translation>
    </message>
    <message>
        <source>Test a backup</source>
        <translation>测试备份</translation>
    </message>
    <message>
        <source>Remove the demonstration</source>
        <translation>删除演示数据</translation>
    </message>
    <message>
        <source>Maintenance of the record</source>
        <translation>数据维护</translation>
    </message>
    <message>
        <source>Back up, test the backup, and review what is due.</source>
        <translation>备份、测试备份，并处理到期事项。</translation>
    </message>
    <message>
        <source>Backup</source>
        <translation>备份</translation>
    </message>
    <message>
        <source>A backup is one file, made while others work and read back at once. Keep it on another machine.</source>
        <translation>备份是一个文件，不影响他人工作，写完立即回读。请存放在另一台机器上。</translation>
    </message>
    <message>
        <source>&amp;Back up…</source>
        <translation>备份(&amp;B)…</translation>
    </message>
    <message>
        <source>&amp;Test a backup…</source>
        <translation>测试备份(&amp;T)…</translation>
    </message>
    <message>
        <source>This record</source>
        <translation>当前数据库</translation>
    </message>
    <message>
        <source>&amp;Check the database</source>
        <translation>检查数据库(&amp;C)</translation>
    </message>
    <message>
        <source>Demonstration</source>
        <translation>演示数据</translation>
    </message>
    <message>
        <source>Re&amp;move…</source>
        <translation>删除(&amp;M)…</translation>
    </message>
    <message>
        <source>Restore or move</source>
        <translation>恢复或迁移</translation>
    </message>
    <message>
        <source>Re&amp;store…</source>
        <translation>恢复(&amp;S)…</translation>
    </message>
    <message>
        <source>Mo&amp;ve to PostgreSQL…</source>
        <translation>迁移到 PostgreSQL(&amp;V)…</translation>
    </message>
    <message>
        <source>Head of the audit trail, to be kept elsewhere: %1</source>
        <translation>审计记录的链头，请另处保存：%1</translation>
    </message>
    <message>
        <source>✓ Checked: sound, schema %1, audit entries: %2</source>
        <translation>✓ 已检查：完好，结构版本 %1，审计记录 %2 条</translation>
    </message>
    <message numerus="yes">
        <source>✗ Checked: %n finding(s), first: %1</source>
        <translation>
            <numerusform>✗ 已检查：发现 %n 个问题，第一个：%1</numerusform>
        </translation>
    </message>
    <message>
        <source>Simulated people: %1, recordings: %2, marks: %3. They are marked everywhere and can go at once; real data stay.</source>
        <translation>模拟人员 %1 名，录制 %2 次，评分 %3 个。它们处处带有标记，可一次删除；真实数据不受影响。</translation>
    </message>
    <message>
        <source>✓ Written and read back. Recordings: %1, marks: %2.
%3</source>
        <translation>✓ 已写入并回读：录制 %1 次，评分 %2 个。
%3</translation>
    </message>
    <message>
        <source>✓ This backup can be restored. Recordings: %1, marks: %2.
%3</source>
        <translation>✓ 该备份可以恢复：录制 %1 次，评分 %2 个。
%3</translation>
    </message>
    <message>
        <source>Removed: simulated people %1, recordings %2</source>
        <translation>已删除：模拟人员 %1 名，录制 %2 次</translation>
    </message>
    <message>
        <source>The simulated people (%1) and all that belongs to them go at once. This cannot be taken back.</source>
        <translation>%1 名模拟人员及其全部数据将一次删除，无法撤销。</translation>
    </message>
    <message>
        <source>No key signs the heads of this station, so whoever can change the place where they are kept can replace them. Make one: Audit trail, Heads.</source>
        <translation>本站的链头没有密钥签名，能改动其保存位置的人就能替换它们。请在“审计记录”的“链头”中生成密钥。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::MarkerEditor</name>
    <message>
        <source>Click on the organ to move the chosen marker there</source>
        <translation>请点击器官，将所选标记点移到该处</translation>
    </message>
    <message>
        <source>Open markers</source>
        <translation>打开标记点</translation>
    </message>
    <message>
        <source>Markers (*.json)</source>
        <translation>标记点 (*.json)</translation>
    </message>
    <message>
        <source>Save markers</source>
        <translation>保存标记点</translation>
    </message>
    <message>
        <source>markers.json</source>
        <translation>markers.json</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>点 %1</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记点</translation>
    </message>
    <message>
        <source>Choose a marker and click on the organ to move it, or give section and ridge. Drag to turn the view.</source>
        <translation>选择一个标记点，点击器官即可移动它，也可以给出截面和脊线。拖动可转动视图。</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名称(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Section</source>
        <translation>截面(&amp;S)</translation>
    </message>
    <message>
        <source>R&amp;idge</source>
        <translation>脊线(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>添加(&amp;A)</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>删除(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>重置(&amp;R)</translation>
    </message>
    <message>
        <source>The markers that belong to this organ</source>
        <translation>恢复该器官自带的标记点</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Sa&amp;ve…</source>
        <translation>保存(&amp;V)…</translation>
    </message>
    <message>
        <source>For later, and for torsio compare --markers</source>
        <translation>供以后使用，也供 torsio compare --markers 使用</translation>
    </message>
</context>
<context>
    <name>torsio::gui::MasteryTable</name>
    <message>
        <source>at least</source>
        <translation>不低于</translation>
    </message>
    <message>
        <source>at most</source>
        <translation>不超过</translation>
    </message>
    <message>
        <source>What rule %1 is about</source>
        <translation>标准 %1 的指标</translation>
    </message>
    <message>
        <source>Direction of rule %1</source>
        <translation>标准 %1 的方向</translation>
    </message>
    <message>
        <source>Threshold of rule %1</source>
        <translation>标准 %1 的阈值</translation>
    </message>
    <message>
        <source>Attempts in a row of rule %1</source>
        <translation>标准 %1 的连续次数</translation>
    </message>
    <message>
        <source>Rules of mastery</source>
        <translation>掌握标准</translation>
    </message>
    <message>
        <source>Add rule</source>
        <translation>添加标准</translation>
    </message>
    <message>
        <source>Remove rule</source>
        <translation>删除标准</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>is</source>
        <translation>关系</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>阈值</translation>
    </message>
    <message>
        <source>In a row</source>
        <translation>连续次数</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ModelComparison</name>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>Loading the organ</source>
        <translation>正在加载器官</translation>
    </message>
    <message>
        <source>Wait until the work that goes on has ended</source>
        <translation>请等待当前的工作结束</translation>
    </message>
    <message>
        <source>Comparing the models</source>
        <translation>正在对比模型</translation>
    </message>
    <message>
        <source>Processing time of %1</source>
        <translation>%1 的计算时间</translation>
    </message>
    <message>
        <source>Not computed yet</source>
        <translation>尚未计算</translation>
    </message>
    <message numerus="yes">
        <source>for the whole twist, %n frame(s) of %1; set-up apart: %2</source>
        <translation>
            <numerusform>为整个扭转的用时：%n 帧，每帧 %1；准备时间另计：%2</numerusform>
        </translation>
    </message>
    <message>
        <source>In equilibrium %1°, %2 mm from the reference</source>
        <translation>平衡时 %1°，与参考解相差 %2 mm</translation>
    </message>
    <message>
        <source>No equilibrium: %1</source>
        <translation>没有平衡：%1</translation>
    </message>
    <message>
        <source>Folder for the report and its tables</source>
        <translation>报告及其表格的文件夹</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>&amp;Organ</source>
        <translation>器官(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Torque</source>
        <translation>扭矩(&amp;T)</translation>
    </message>
    <message>
        <source> N m</source>
        <translation> N m</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>对比(&amp;C)</translation>
    </message>
    <message>
        <source>Computes all models anew; a quarter of a minute to a minute</source>
        <translation>重新计算全部模型，约需 15 秒到 1 分钟</translation>
    </message>
    <message>
        <source>Re&amp;play</source>
        <translation>重放(&amp;P)</translation>
    </message>
    <message>
        <source>Shows each model as fast as it was computed</source>
        <translation>按实际计算速度显示每个模型</translation>
    </message>
    <message>
        <source>&amp;Save report…</source>
        <translation>保存报告(&amp;S)…</translation>
    </message>
    <message>
        <source>PDF, JSON and tables, as torsio compare writes them</source>
        <translation>PDF、JSON 和表格，与 torsio compare 写出的相同</translation>
    </message>
    <message>
        <source>Compare twists the organ about its own axis by all three models under the same torque. Each clock shows how long its model computed until the twist stood still. Drag a view to turn all of them.</source>
        <translation>“对比”用三种模型在相同扭矩下绕器官自身的轴扭转器官。每个时钟显示该模型计算到扭转静止所用的时间。拖动任一视图可同时转动全部视图。</translation>
    </message>
    <message>
        <source>PM: twist model</source>
        <translation>PM：扭转模型</translation>
    </message>
    <message>
        <source>FEM: finite elements</source>
        <translation>FEM：有限元</translation>
    </message>
    <message>
        <source>MSM: springs</source>
        <translation>MSM：弹簧</translation>
    </message>
</context>
<context>
    <name>torsio::gui::MovePage</name>
    <message>
        <source>The line is in the clipboard</source>
        <translation>该行已复制到剪贴板</translation>
    </message>
    <message>
        <source>Looking at the server</source>
        <translation>正在查看服务器</translation>
    </message>
    <message>
        <source>Moving the record to the server</source>
        <translation>正在将记录迁移到服务器</translation>
    </message>
    <message>
        <source>Turning this station to the server</source>
        <translation>正在将此工作站切换到服务器</translation>
    </message>
    <message>
        <source>This station now works with the record at %1. The old file stays as it was; do not use it any more</source>
        <translation>此工作站现在使用位于 %1 的记录。旧文件保持原样，请不要再使用</translation>
    </message>
    <message>
        <source>The server&apos;s administrator makes an empty database and an account for Torsio. The password is used for this only and stored nowhere.</source>
        <translation>请服务器管理员为 Torsio 建立一个空数据库和一个账户。密码仅用于此操作，不会保存在任何地方。</translation>
    </message>
    <message>
        <source>✓ %1 answers at %2. The database is empty: the record can go there.</source>
        <translation>✓ %1 在 %2 应答。数据库为空：可以将记录迁移到那里。</translation>
    </message>
    <message>
        <source>✓ %1 answers at %2. Torsio&apos;s tables are there and empty: the record can go there.</source>
        <translation>✓ %1 在 %2 应答。Torsio 的表已存在且为空：可以将记录迁移到那里。</translation>
    </message>
    <message>
        <source>✗ %1 answers at %2, but the record cannot go there: %3.</source>
        <translation>✗ %1 在 %2 应答，但无法将记录迁移到那里：%3。</translation>
    </message>
    <message>
        <source>✓ %1 answers at %2. There is a record in this database already: this station can join it.</source>
        <translation>✓ %1 在 %2 应答。该数据库中已有一份记录：此工作站可以加入。</translation>
    </message>
    <message>
        <source>✓ %1 at %2</source>
        <translation>✓ %1，位于 %2</translation>
    </message>
    <message>
        <source>✓ Copied and compared: %1 rows of %2 tables have the same counts and hashes on both sides, and the audit trail of %3 entries fits.</source>
        <translation>✓ 已复制并核对：%2 个表的 %1 行在两边的数量和哈希值一致，%3 条审计记录相符。</translation>
    </message>
    <message>
        <source>Everything is copied and both sides are compared, row by row. Your record stays as it is. Nobody may be at work meanwhile: close Torsio at all other stations.</source>
        <translation>复制全部内容并逐行核对两边。您的记录保持不变。期间不得有人使用：请关闭其他所有工作站上的 Torsio。</translation>
    </message>
    <message>
        <source>From then on this station works with the server. At every other station open this page, give the same address, and join the record.</source>
        <translation>此后该工作站使用服务器。在其他每个工作站打开此页面，填写相同的地址并加入该记录。</translation>
    </message>
    <message>
        <source>From then on this station works with that record, and everybody signs in with the names and passwords of that record. The record here stays as it is and is not used any more.</source>
        <translation>此后该工作站使用那份记录，所有人用那份记录中的登录名和密码登录。这里的记录保持原样，不再使用。</translation>
    </message>
    <message>
        <source>Torsio stores no password. For this station put the line below, with the real password in place of the last word, into the password file of this computer&apos;s account: .pgpass in the home folder, readable by the account only (on Windows %APPDATA%\postgresql\pgpass.conf). Then switch.</source>
        <translation>Torsio 不保存密码。请将下面一行（把最后一个词换成真实密码）写入本机账户的密码文件：主目录中的 .pgpass，仅该账户可读（Windows 上为 %APPDATA%\postgresql\pgpass.conf），然后切换。</translation>
    </message>
    <message>
        <source>Move to PostgreSQL</source>
        <translation>迁移到 PostgreSQL</translation>
    </message>
    <message>
        <source>One record on a server, for several stations. The file of today stays as it is.</source>
        <translation>服务器上的一份记录，供多个工作站使用。现在的文件保持不变。</translation>
    </message>
    <message>
        <source>&amp;Back to maintenance</source>
        <translation>返回维护(&amp;B)</translation>
    </message>
    <message>
        <source>1  The server</source>
        <translation>1  服务器</translation>
    </message>
    <message>
        <source>&amp;Computer</source>
        <translation>计算机(&amp;C)</translation>
    </message>
    <message>
        <source>P&amp;ort</source>
        <translation>端口(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Database</source>
        <translation>数据库(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Account</source>
        <translation>账户(&amp;A)</translation>
    </message>
    <message>
        <source>Pass&amp;word</source>
        <translation>密码(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Schema (leave empty)</source>
        <translation>模式（留空）(&amp;S)</translation>
    </message>
    <message>
        <source>server.hospital.example</source>
        <translation>server.hospital.example</translation>
    </message>
    <message>
        <source>&amp;Test the connection</source>
        <translation>测试连接(&amp;T)</translation>
    </message>
    <message>
        <source>2  Copy and compare</source>
        <translation>2  复制并核对</translation>
    </message>
    <message>
        <source>Co&amp;py the record</source>
        <translation>复制记录(&amp;P)</translation>
    </message>
    <message>
        <source>3  This station</source>
        <translation>3  此工作站</translation>
    </message>
    <message>
        <source>Line of the password file</source>
        <translation>密码文件中的一行</translation>
    </message>
    <message>
        <source>Copy the &amp;line</source>
        <translation>复制该行(&amp;L)</translation>
    </message>
    <message>
        <source>S&amp;witch this station over</source>
        <translation>切换此工作站(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Encryption</source>
        <translation>加密(&amp;E)</translation>
    </message>
    <message>
        <source>Certificate of its authorit&amp;y</source>
        <translation>其颁发机构的证书(&amp;Y)</translation>
    </message>
    <message>
        <source>as the server offers it, unchecked</source>
        <translation>按服务器提供的方式，不核验</translation>
    </message>
    <message>
        <source>checked: this server and no other</source>
        <translation>核验：只连接这一台服务器</translation>
    </message>
    <message>
        <source>the account&apos;s own (~/.postgresql/root.crt)</source>
        <translation>账号自带的证书（~/.postgresql/root.crt）</translation>
    </message>
</context>
<context>
    <name>torsio::gui::NextStepPage</name>
    <message>
        <source>Look at it</source>
        <translation>查看</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>阅读</translation>
    </message>
    <message>
        <source>Nothing is planned for you yet</source>
        <translation>尚未为您安排训练</translation>
    </message>
    <message>
        <source>You are in no cohort. An administrator has to add you; free practice is open meanwhile.</source>
        <translation>您尚未加入任何批次，请联系管理员。在此期间可以自由练习。</translation>
    </message>
    <message>
        <source>Your cohort follows no curriculum yet. Free practice is open meanwhile.</source>
        <translation>您的批次尚无课程。在此期间可以自由练习。</translation>
    </message>
    <message>
        <source>Your training time is complete</source>
        <translation>您的训练时间已完成</translation>
    </message>
    <message>
        <source>Nothing is open now</source>
        <translation>目前没有开放的模块</translation>
    </message>
    <message>
        <source>Look at your trend, or take your transcript.</source>
        <translation>可以查看趋势或打印成绩单。</translation>
    </message>
    <message>
        <source>On the real arm: %1</source>
        <translation>实物手臂训练：%1</translation>
    </message>
    <message>
        <source>%1 left. The timer logs your training time; nothing is recorded.</source>
        <translation>剩余 %1。计时器记录训练时间，不做其他记录。</translation>
    </message>
    <message>
        <source>takes at most %1</source>
        <translation>最多需要 %1</translation>
    </message>
    <message>
        <source>the last attempt</source>
        <translation>最后一次尝试</translation>
    </message>
    <message>
        <source>&amp;Begin on the real arm</source>
        <translation>开始实物手臂训练(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Begin graded run</source>
        <translation>开始计分操作(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Begin</source>
        <translation>开始(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Practise first</source>
        <translation>先练习(&amp;P)</translation>
    </message>
    <message>
        <source>%1  ·  %2</source>
        <translation>%1  ·  %2</translation>
    </message>
    <message>
        <source>Not tried yet</source>
        <translation>尚未尝试</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>趋势</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Begin %1</source>
        <translation>开始 %1</translation>
    </message>
    <message>
        <source>Trainee %1</source>
        <translation>学员 %1</translation>
    </message>
    <message>
        <source>%1  ·  %2 of %3 trained</source>
        <translation>%1  ·  已训练 %2 / %3</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>欢迎</translation>
    </message>
    <message>
        <source>&amp;Consent</source>
        <translation>同意书(&amp;C)</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>All modules</source>
        <translation>全部模块</translation>
    </message>
    <message numerus="yes">
        <source>%n remark(s) of physicians that you have not read</source>
        <translation>
            <numerusform>有 %n 条医师评语未读</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) left</source>
        <translation>
            <numerusform>还剩 %n 次尝试</numerusform>
        </translation>
    </message>
    <message>
        <source>This session</source>
        <translation>本次训练</translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>%n 次操作</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n twist(s)</source>
        <translation>
            <numerusform>%n 次扭转</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 released on target</source>
        <translation>%1 次达标释放</translation>
    </message>
    <message>
        <source>Your best twist: %1° off a target of %2°, at %3 of “%4”.</source>
        <translation>最佳扭转：与目标 %2° 相差 %1°，位于“%4”的 %3。</translation>
    </message>
    <message>
        <source>The organ at your best twist</source>
        <translation>最佳扭转时的器官</translation>
    </message>
    <message>
        <source>Your run of %1 was interrupted. The %2 that were recorded count as training time; no attempt was used.</source>
        <translation>您在 %1 的操作被中断。已记录的 %2 计入训练时间；未占用尝试次数。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::OrderedList</name>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上移</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>下移</translation>
    </message>
    <message>
        <source>Moves it before the one above.</source>
        <translation>移到上一项之前。</translation>
    </message>
    <message>
        <source>Moves it behind the one below.</source>
        <translation>移到下一项之后。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::OrganFindings</name>
    <message>
        <source>refused</source>
        <translation>拒绝</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>for your information</source>
        <translation>供参考</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>已拒绝</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>已接受</translation>
    </message>
    <message numerus="yes">
        <source>Accepted with %n warning(s), which stay with the organ</source>
        <translation>
            <numerusform>带 %n 条警告接受，警告随器官保存</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 个三角形</translation>
    </message>
    <message>
        <source>%1 ml</source>
        <translation>%1 ml</translation>
    </message>
    <message>
        <source>axis %1 mm</source>
        <translation>轴长 %1 mm</translation>
    </message>
    <message>
        <source>%1 times as long as wide</source>
        <translation>长为宽的 %1 倍</translation>
    </message>
    <message>
        <source>at 60° det F falls to %1</source>
        <translation>扭转 60° 时 det F 降至 %1</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
    <message>
        <source>Where: %1</source>
        <translation>位置：%1</translation>
    </message>
    <message>
        <source>Measured: %1</source>
        <translation>测得：%1</translation>
    </message>
    <message>
        <source>Nothing had to be mended, and nothing is to be told.</source>
        <translation>无需修补，也无须提示。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::OrganMarks</name>
    <message>
        <source>held end</source>
        <translation>固定端</translation>
    </message>
    <message>
        <source>free end</source>
        <translation>自由端</translation>
    </message>
    <message>
        <source>widest</source>
        <translation>最宽处</translation>
    </message>
    <message>
        <source>narrowest</source>
        <translation>最窄处</translation>
    </message>
</context>
<context>
    <name>torsio::gui::OrganPicture</name>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>There is no picture: no surface could be made of the file. The findings say why.</source>
        <translation>没有图像：无法由该文件得到曲面。原因见各条发现。</translation>
    </message>
    <message>
        <source>Turns the free end about the organ&apos;s own axis, as it is judged</source>
        <translation>使自由端绕器官自身轴线转动，与评判时相同</translation>
    </message>
    <message>
        <source>Axis and landmarks</source>
        <translation>轴线与标志点</translation>
    </message>
    <message>
        <source>Sections and ridges</source>
        <translation>截面与脊线</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>侧面</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上方</translation>
    </message>
    <message>
        <source>Test &amp;twist</source>
        <translation>试扭转(&amp;T)</translation>
    </message>
</context>
<context>
    <name>torsio::gui::OrganSettings</name>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>文件的单位(&amp;U)</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>毫米</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>厘米</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>米</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>微米</translation>
    </message>
    <message>
        <source>another</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>&amp;Millimetres in one unit</source>
        <translation>每单位的毫米数(&amp;M)</translation>
    </message>
    <message>
        <source>Close holes and open ends</source>
        <translation>封闭孔洞和开放的端部</translation>
    </message>
    <message>
        <source>&amp;Anatomy</source>
        <translation>解剖结构(&amp;A)</translation>
    </message>
    <message>
        <source>Not known: twists about its own axis</source>
        <translation>未知：绕自身轴线扭转</translation>
    </message>
    <message>
        <source>Thickness of its &amp;wall</source>
        <translation>壁厚(&amp;W)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Ends of the organ</source>
        <translation>器官的两端</translation>
    </message>
    <message>
        <source>found from its shape</source>
        <translation>由形状求得</translation>
    </message>
    <message>
        <source>given, in millimetres: left, back, up</source>
        <translation>给定（毫米：左、后、上）</translation>
    </message>
    <message>
        <source>&amp;Held end</source>
        <translation>固定端(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Free end</source>
        <translation>自由端(&amp;F)</translation>
    </message>
    <message>
        <source>to the left</source>
        <translation>向左</translation>
    </message>
    <message>
        <source>to the back</source>
        <translation>向后</translation>
    </message>
    <message>
        <source>up</source>
        <translation>向上</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Held end</source>
        <translation>固定端</translation>
    </message>
    <message>
        <source>Free end</source>
        <translation>自由端</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>点选</translation>
    </message>
    <message>
        <source>Then click on the organ where this end lies</source>
        <translation>随后在器官上点击该端所在处</translation>
    </message>
    <message>
        <source>Click the held end</source>
        <translation>点选固定端</translation>
    </message>
    <message>
        <source>Click the free end</source>
        <translation>点选自由端</translation>
    </message>
    <message>
        <source>cut there: what lies beyond follows as a whole</source>
        <translation>在此截断：以外的部分整体跟随</translation>
    </message>
</context>
<context>
    <name>torsio::gui::OrganWizard</name>
    <message>
        <source>Mesh of an organ</source>
        <translation>器官的网格</translation>
    </message>
    <message>
        <source>Meshes (*.obj *.stl *.ply *.off *.glb *.gltf *.dae);;All files (*)</source>
        <translation>网格 (*.obj *.stl *.ply *.off *.glb *.gltf *.dae);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>NIfTI files (*.nii *.nii.gz *.hdr *.hdr.gz);;All files (*)</source>
        <translation>NIfTI 文件 (*.nii *.nii.gz *.hdr *.hdr.gz);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Folder of DICOM files</source>
        <translation>DICOM 文件夹</translation>
    </message>
    <message>
        <source>Wait until the work that goes on has ended</source>
        <translation>请等待当前的工作结束</translation>
    </message>
    <message>
        <source>Judging the organ</source>
        <translation>正在评判器官</translation>
    </message>
    <message>
        <source>Reading the scan</source>
        <translation>正在读取扫描</translation>
    </message>
    <message>
        <source>Looking for the organ</source>
        <translation>正在寻找器官</translation>
    </message>
    <message>
        <source>Drawing the organ</source>
        <translation>正在绘制器官</translation>
    </message>
    <message>
        <source>organ</source>
        <translation>器官</translation>
    </message>
    <message>
        <source>Save organ</source>
        <translation>保存器官</translation>
    </message>
    <message>
        <source>Organ files (*.organ)</source>
        <translation>器官文件 (*.organ)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>Back to practice</source>
        <translation>返回练习</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Choose a mesh…</source>
        <translation>选择网格…</translation>
    </message>
    <message>
        <source>A CT, or a mask of labels from another program. You look at its slices, say what the organ is, and mend what was found. Names of patients are neither shown nor kept.</source>
        <translation>CT，或其他程序给出的标签掩膜。您可查看切片，指明器官，并修补找到的结果。患者姓名既不显示也不保存。</translation>
    </message>
    <message>
        <source>Take slices at uneven distances</source>
        <translation>接受间距不均的切片</translation>
    </message>
    <message>
        <source>NIfTI file…</source>
        <translation>NIfTI 文件…</translation>
    </message>
    <message>
        <source>DICOM folder…</source>
        <translation>DICOM 文件夹…</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>所得结果</translation>
    </message>
    <message>
        <source>Judgement</source>
        <translation>评判</translation>
    </message>
    <message>
        <source>What you know of it</source>
        <translation>您所知的情况</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>Judge again</source>
        <translation>重新评判</translation>
    </message>
    <message>
        <source>With what you know of it now</source>
        <translation>按现在所知的情况</translation>
    </message>
    <message>
        <source>Save organ…</source>
        <translation>保存器官…</translation>
    </message>
    <message>
        <source>Open in the simulator</source>
        <translation>在模拟器中打开</translation>
    </message>
    <message>
        <source>Saves the organ first, so that recordings made on it can be replayed</source>
        <translation>先保存器官，以便在其上所作的记录能够重放</translation>
    </message>
    <message>
        <source>&amp;Series, where a folder holds several</source>
        <translation>序列（文件夹含多个时）(&amp;S)</translation>
    </message>
    <message>
        <source>the one with the most slices</source>
        <translation>切片最多的一个</translation>
    </message>
    <message>
        <source>Bring an organ: a mesh or a scan of your own becomes one that can be twisted, once it is judged.</source>
        <translation>导入器官：您自己的网格或扫描经评判后，即成为可以扭转的器官。</translation>
    </message>
    <message>
        <source>A closed surface of one organ: obj, stl, ply, off, glb, gltf or dae. It is read apart, checked, mended where that is safe, and twisted to see how it bears it.</source>
        <translation>一个器官的封闭表面：obj、stl、ply、off、glb、gltf 或 dae。程序在独立进程中读取、检查，在安全时修补，并试扭转以查看其承受情况。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::OwnRecordCard</name>
    <message>
        <source>You asked for %1 on %2; it waits for the centre.</source>
        <translation>您于 %2 申请了%1；正在等待中心处理。</translation>
    </message>
    <message>
        <source>You asked for %1 on %2: %3. %4</source>
        <translation>您于 %2 申请了%1：%3。%4</translation>
    </message>
    <message>
        <source>Ask for erasing</source>
        <translation>申请删除</translation>
    </message>
    <message>
        <source>Your name and your recordings are removed, and nobody can bring them back; marks stay without a person. Ask for it?</source>
        <translation>您的姓名和录制将被删除，任何人都无法恢复；评分保留但不再关联到人。要提出申请吗？</translation>
    </message>
    <message>
        <source>The centre finds your request in its list.</source>
        <translation>中心会在其列表中看到您的申请。</translation>
    </message>
    <message>
        <source>Your record</source>
        <translation>您的记录</translation>
    </message>
    <message>
        <source>You may ask for a copy of everything that is kept about you, or that it be erased. The centre answers here.</source>
        <translation>您可以索取关于您的全部保存内容的副本，或要求将其删除。中心在此处答复。</translation>
    </message>
    <message>
        <source>Ask for a &amp;copy…</source>
        <translation>索取副本(&amp;C)…</translation>
    </message>
    <message>
        <source>Ask for &amp;erasing…</source>
        <translation>申请删除(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Take the request back</source>
        <translation>收回申请(&amp;T)</translation>
    </message>
</context>
<context>
    <name>torsio::gui::PaperDialog</name>
    <message>
        <source>Marks on paper</source>
        <translation>纸质评分</translation>
    </message>
    <message>
        <source>Two people type each sheet, each for themselves; it counts when both are alike.</source>
        <translation>每份评分表由两人各自录入；两份一致时才计入。</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>关闭(&amp;L)</translation>
    </message>
    <message>
        <source>Co&amp;mment on the paper</source>
        <translation>纸上的评语(&amp;M)</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>案例</translation>
    </message>
    <message>
        <source>Rater</source>
        <translation>评分者</translation>
    </message>
    <message>
        <source>Called</source>
        <translation>呼叫时间</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>No live sheet is missing. Sheets appear here once their trainee was called.</source>
        <translation>没有缺少的现场评分表。学员被呼叫后，其评分表会出现在这里。</translation>
    </message>
    <message>
        <source>! typed twice, not alike</source>
        <translation>! 已录入两次，不一致</translation>
    </message>
    <message>
        <source>◐ typed once: type it again</source>
        <translation>◐ 已录入一次：请再录入一次</translation>
    </message>
    <message>
        <source>○ not typed yet</source>
        <translation>○ 尚未录入</translation>
    </message>
    <message>
        <source>cannot be assessed</source>
        <translation>无法评分</translation>
    </message>
    <message>
        <source>reason on the paper</source>
        <translation>纸上的理由</translation>
    </message>
    <message>
        <source>Reason: %1</source>
        <translation>理由：%1</translation>
    </message>
    <message>
        <source>Choose a sheet at the left</source>
        <translation>请在左侧选择一份评分表</translation>
    </message>
    <message>
        <source>Case %1, rater %2</source>
        <translation>案例 %1，评分者 %2</translation>
    </message>
    <message>
        <source>Overall mark</source>
        <translation>总分</translation>
    </message>
    <message>
        <source>Kept. It counts once somebody else has typed the same.</source>
        <translation>已保存。另一人录入相同内容后即计入。</translation>
    </message>
    <message>
        <source>Not alike in the rows with a sign: look at the paper again. Nothing counts so far.</source>
        <translation>带标记的行不一致：请再看一遍纸质表。目前均不计入。</translation>
    </message>
    <message>
        <source>Alike: the sheet counts now.</source>
        <translation>一致：该评分表现已计入。</translation>
    </message>
    <message>
        <source>&amp;Save what I typed</source>
        <translation>保存我录入的内容(&amp;S)</translation>
    </message>
    <message>
        <source>◐ typed by you, waits for another</source>
        <translation>◐ 您已录入，等待另一人</translation>
    </message>
</context>
<context>
    <name>torsio::gui::PasswordPanel</name>
    <message>
        <source>The two are not the same yet</source>
        <translation>两次输入尚不一致</translation>
    </message>
    <message>
        <source>Choose a new password</source>
        <translation>设置新密码</translation>
    </message>
    <message>
        <source>Your password was set by somebody else. Choose one that only you know: at least fifteen characters, a short sentence for example.</source>
        <translation>当前密码由他人设置。请设置只有您知道的密码：至少十五个字符，例如一个短句。</translation>
    </message>
    <message>
        <source>At least fifteen characters, a short sentence for example. Nothing else is asked for.</source>
        <translation>至少十五个字符，例如一个短句，没有其他要求。</translation>
    </message>
    <message>
        <source>&amp;Present password</source>
        <translation>当前密码(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;New password</source>
        <translation>新密码(&amp;N)</translation>
    </message>
    <message>
        <source>Back to the sign-in</source>
        <translation>返回登录</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Save password</source>
        <translation>保存密码</translation>
    </message>
    <message>
        <source>Repeat p&amp;assword</source>
        <translation>重复密码(&amp;A)</translation>
    </message>
</context>
<context>
    <name>torsio::gui::PeopleDialog</name>
    <message>
        <source>Code</source>
        <translation>代码</translation>
    </message>
    <message>
        <source>Sex</source>
        <translation>性别</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>Experience</source>
        <translation>经验</translation>
    </message>
    <message>
        <source>Class of raters</source>
        <translation>评分者类别</translation>
    </message>
    <message>
        <source>Nobody is left to choose.</source>
        <translation>没有可选人员。</translation>
    </message>
    <message numerus="yes">
        <source>Take %n</source>
        <translation>
            <numerusform>选取 %n 人</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::PersonRequestsDialog</name>
    <message>
        <source>What people asked for</source>
        <translation>人员提出的申请</translation>
    </message>
    <message>
        <source>&amp;Go to the person</source>
        <translation>转到此人(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Done…</source>
        <translation>已完成(&amp;D)…</translation>
    </message>
    <message>
        <source>De&amp;cline…</source>
        <translation>拒绝(&amp;C)…</translation>
    </message>
    <message>
        <source>Trainees ask on their page for a copy of their record, or that it be erased. Go to the person, do it there, then say here that it is done.</source>
        <translation>学员可在自己的页面索取记录副本，或要求删除记录。请转到此人，在那里处理，然后在此标记为已完成。</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>人员</translation>
    </message>
    <message>
        <source>Asked for</source>
        <translation>申请内容</translation>
    </message>
    <message>
        <source>When</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>答复</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>Answered</source>
        <translation>答复时间</translation>
    </message>
    <message>
        <source>Nobody has asked for anything.</source>
        <translation>尚无人提出申请。</translation>
    </message>
    <message>
        <source>waits</source>
        <translation>等待中</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>%1: say what was done, and when it was handed over.</source>
        <translation>%1：请说明做了什么，以及何时交付。</translation>
    </message>
    <message>
        <source>Decline</source>
        <translation>拒绝</translation>
    </message>
    <message>
        <source>%1 reads this reason on their page.</source>
        <translation>%1 会在自己的页面看到此理由。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::PowerDialog</name>
    <message>
        <source>two groups (t test, Cohen&apos;s d)</source>
        <translation>两组（t 检验，Cohen d）</translation>
    </message>
    <message>
        <source>one group before and after (d of the differences)</source>
        <translation>一组前后（差值的 d）</translation>
    </message>
    <message>
        <source>several groups (analysis of variance, Cohen&apos;s f)</source>
        <translation>多组（方差分析，Cohen f）</translation>
    </message>
    <message>
        <source>&amp;Comparison</source>
        <translation>比较(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Groups</source>
        <translation>组数(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Effect that must not be missed</source>
        <translation>不可漏检的效应(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Power wanted</source>
        <translation>所需效能(&amp;P)</translation>
    </message>
    <message>
        <source>Significance &amp;level</source>
        <translation>显著性水平(&amp;L)</translation>
    </message>
    <message>
        <source>Co&amp;rrelation of the scores before and after</source>
        <translation>前后得分的相关(&amp;R)</translation>
    </message>
    <message>
        <source>Needed</source>
        <translation>需要</translation>
    </message>
    <message>
        <source>Trainees at &amp;hand, each group</source>
        <translation>每组现有学员(&amp;H)</translation>
    </message>
    <message>
        <source>What they show</source>
        <translation>能够表明</translation>
    </message>
    <message>
        <source>power %1 for this effect; with power %2 they detect an effect of %3</source>
        <translation>对该效应的效能为 %1；以效能 %2 可检出 %3 的效应</translation>
    </message>
    <message numerus="yes">
        <source>%n trainee(s)</source>
        <translation>
            <numerusform>%n 名学员</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trainee(s) in each group; %1 when scores are adjusted for the score before</source>
        <translation>
            <numerusform>每组 %n 名学员；以训练前得分校正时为 %1 名</numerusform>
        </translation>
    </message>
    <message>
        <source>How many trainees and raters?</source>
        <translation>需要多少学员和评分者？</translation>
    </message>
    <message>
        <source>agreement of raters (ICC, width of its 95 % interval)</source>
        <translation>评分者间一致性（ICC，其 95 % 区间的宽度）</translation>
    </message>
    <message>
        <source>Agreement of one rater e&amp;xpected (ICC)</source>
        <translation>预期的单个评分者一致性（ICC）(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Width of its interval, at most</source>
        <translation>其区间宽度，至多(&amp;W)</translation>
    </message>
    <message>
        <source>R&amp;aters who score everybody</source>
        <translation>为所有人评分的评分者(&amp;A)</translation>
    </message>
    <message>
        <source>How many raters a mean score needs stands under Results, in the section Raters, once marks are there.</source>
        <translation>平均得分需要多少评分者，有评分之后见“结果”中的“评分者”一节。</translation>
    </message>
    <message>
        <source>%1 trainees, each scored by %2 raters</source>
        <translation>%1 名学员，每人由 %2 名评分者评分</translation>
    </message>
    <message>
        <source>%1 raters are enough for this width</source>
        <translation>%1 名评分者足以达到此宽度</translation>
    </message>
    <message>
        <source>too few for this width, however many raters score them</source>
        <translation>无论由多少评分者评分，都太少，达不到此宽度</translation>
    </message>
    <message>
        <source>Trainees at &amp;hand</source>
        <translation>现有学员(&amp;H)</translation>
    </message>
</context>
<context>
    <name>torsio::gui::PracticePage</name>
    <message>
        <source>A recording is going on. Stop it first</source>
        <translation>正在录制，请先停止</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ProblemPanel</name>
    <message>
        <source>Hide details</source>
        <translation>隐藏详情</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>详情</translation>
    </message>
    <message>
        <source>A problem</source>
        <translation>出现问题</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>torsio::gui::QuestionsCard</name>
    <message>
        <source>Trainees ask you: %1</source>
        <translation>学员向您提问：%1</translation>
    </message>
    <message>
        <source>Trainees ask you</source>
        <translation>学员向您提问</translation>
    </message>
    <message>
        <source>%1, %2, at %3: waiting for %4</source>
        <translation>%1，%2，位于 %3：已等待 %4</translation>
    </message>
    <message>
        <source>Answer…</source>
        <translation>回答…</translation>
    </message>
    <message>
        <source>Answer %1</source>
        <translation>回答 %1</translation>
    </message>
    <message>
        <source>Opening the run</source>
        <translation>正在打开操作</translation>
    </message>
    <message>
        <source>A question of %1</source>
        <translation>%1 的提问</translation>
    </message>
    <message>
        <source>%1 asks about this moment of “%2”.</source>
        <translation>%1 就“%2”的这一时刻提问。</translation>
    </message>
    <message>
        <source>Your &amp;answer; the trainee sees that it is yours</source>
        <translation>您的回答(&amp;A)；学员能看到是您回答的</translation>
    </message>
    <message>
        <source>&amp;Send</source>
        <translation>发送(&amp;S)</translation>
    </message>
    <message>
        <source>The answer is with %1</source>
        <translation>回答已送达 %1</translation>
    </message>
    <message>
        <source>Your last answers to trainees</source>
        <translation>您最近给学员的答复</translation>
    </message>
    <message>
        <source>You answered %1</source>
        <translation>您答复 %1</translation>
    </message>
</context>
<context>
    <name>torsio::gui::QueuePage</name>
    <message>
        <source>Your queue</source>
        <translation>您的待评列表</translation>
    </message>
    <message>
        <source>Cases are blinded and shuffled for you alone. Nobody sees your marks before all have submitted, and you see nobody&apos;s.</source>
        <translation>案例已盲化，并为您单独打乱顺序。在所有人提交之前，没有人能看到您的评分，您也看不到他人的评分。</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>待评</translation>
    </message>
    <message>
        <source>Drafts</source>
        <translation>草稿</translation>
    </message>
    <message>
        <source>Time needed</source>
        <translation>所需时间</translation>
    </message>
    <message>
        <source>Next deadline</source>
        <translation>最近截止日期</translation>
    </message>
    <message>
        <source>Also waiting</source>
        <translation>其他待办</translation>
    </message>
    <message>
        <source>Rater cali&amp;bration</source>
        <translation>评分校准(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Live sheet</source>
        <translation>现场评分表(&amp;L)</translation>
    </message>
    <message>
        <source>Discrep&amp;ancy review</source>
        <translation>评分分歧复核(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Evaluation</source>
        <translation>评价(&amp;E)</translation>
    </message>
    <message>
        <source>Your cases</source>
        <translation>您的案例</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>案例</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Due</source>
        <translation>截止</translation>
    </message>
    <message>
        <source>No recorded case is assigned to you. New ones appear here by themselves.</source>
        <translation>没有分配给您的录制案例。新案例会自动出现在这里。</translation>
    </message>
    <message>
        <source>%1 submitted so far</source>
        <translation>已提交 %1 份</translation>
    </message>
    <message>
        <source>begun and saved with every key</source>
        <translation>已开始，每次按键均已保存</translation>
    </message>
    <message>
        <source>nothing is half done</source>
        <translation>没有未完成的草稿</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分钟</translation>
    </message>
    <message>
        <source>at your own pace so far</source>
        <translation>按您目前的速度</translation>
    </message>
    <message>
        <source>from the length of the recordings</source>
        <translation>按录制时长估计</translation>
    </message>
    <message>
        <source>%1 overdue</source>
        <translation>%1 份已逾期</translation>
    </message>
    <message>
        <source>nothing is overdue</source>
        <translation>没有逾期</translation>
    </message>
    <message>
        <source>Before the first case: score the reference runs and see how far you are from the panel.</source>
        <translation>开始第一个案例之前：为参考操作评分，看看与专家组的差距。</translation>
    </message>
    <message>
        <source>All have submitted. Your marks that differ from the others: %1.</source>
        <translation>所有人均已提交。您与他人差异较大的评分：%1。</translation>
    </message>
    <message>
        <source>Tissue models that ask for your nine marks: %1.</source>
        <translation>等待您九项评分的组织模型：%1 个。</translation>
    </message>
    <message>
        <source>&amp;Continue the draft</source>
        <translation>继续草稿(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Continue</source>
        <translation>继续(&amp;C)</translation>
    </message>
    <message>
        <source>All done</source>
        <translation>全部完成</translation>
    </message>
    <message>
        <source>submitted</source>
        <translation>已提交</translation>
    </message>
    <message>
        <source>overdue</source>
        <translation>已逾期</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>草稿</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>待评</translation>
    </message>
    <message>
        <source>Case %1</source>
        <translation>案例 %1</translation>
    </message>
    <message>
        <source>Called to the real arm, your sheet is not in: %1. To be called: %2.</source>
        <translation>已呼叫到实物手臂、您尚未提交：%1。待呼叫：%2。</translation>
    </message>
    <message>
        <source>Cases that will be called to the real arm: %1. The sheet follows the call.</source>
        <translation>将被呼叫到实物手臂的案例：%1。评分表会随呼叫打开。</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 小时 %2 分钟</translation>
    </message>
    <message>
        <source>%1, in %2 of your time: thank you</source>
        <translation>%1，共用您 %2，谢谢</translation>
    </message>
    <message numerus="yes">
        <source>%n case(s) fit into ten minutes, %1</source>
        <translation>
            <numerusform>十分钟内可完成 %n 个案例，%1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::Rail</name>
    <message>
        <source>Pages</source>
        <translation>页面</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Collapse sidebar</source>
        <translation>收起侧栏</translation>
    </message>
    <message>
        <source>Expand sidebar</source>
        <translation>展开侧栏</translation>
    </message>
</context>
<context>
    <name>torsio::gui::RaterCalibrationDialog</name>
    <message>
        <source>&amp;Add as a reference run</source>
        <translation>添加为参考操作(&amp;A)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Reference runs for rater calibration</source>
        <translation>评分校准用的参考操作</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Recording of</source>
        <translation>记录对象</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>器官</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Mark of the panel</source>
        <translation>专家组评分</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>专家组</translation>
    </message>
    <message>
        <source>Added</source>
        <translation>添加时间</translation>
    </message>
    <message>
        <source>Reference runs</source>
        <translation>参考操作</translation>
    </message>
    <message>
        <source>None yet: physicians begin without rater calibration.</source>
        <translation>尚无：医师将不经校准直接开始。</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>阶段</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>记录时间</translation>
    </message>
    <message>
        <source>Recordings to choose from</source>
        <translation>可选的记录</translation>
    </message>
    <message>
        <source>&amp;Rubric</source>
        <translation>评分标准(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Mark of the panel, points</source>
        <translation>专家组评分（分）(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Physicians on the panel</source>
        <translation>专家组医师人数(&amp;P)</translation>
    </message>
    <message>
        <source>Every physician scores these runs before the first real case and sees how far the own mark is from the panel&apos;s. Two are usual: one weak, one good.</source>
        <translation>每位医师在第一个正式案例之前为这些操作评分，并看到自己与专家组的差距。通常为两个：一个较差，一个较好。</translation>
    </message>
    <message>
        <source>Every physician scores these runs before the first real case and sees how far the own mark is from the panel&apos;s.</source>
        <translation>每位医师在第一个正式案例之前为这些操作评分，并看到自己与专家组的差距。</translation>
    </message>
    <message>
        <source>Reference %1</source>
        <translation>参考 %1</translation>
    </message>
    <message>
        <source>The reference run is added to rater calibration</source>
        <translation>参考操作已加入评分校准</translation>
    </message>
    <message>
        <source>&amp;Withdraw…</source>
        <translation>撤回(&amp;W)…</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>No physician is given the chosen run any more; nothing is deleted</source>
        <translation>所选参考操作不再提供给任何医师；不会删除任何内容</translation>
    </message>
    <message>
        <source>No recording can be offered: each is being scored, is or was a reference run, or is incomplete.</source>
        <translation>没有可供选择的录制：每一段都正在评分、是或曾是参考操作，或者不完整。</translation>
    </message>
    <message>
        <source>The panel scores the run together before it is used. Keep the runs as they are where you can, so that every physician calibrates on the same ones.</source>
        <translation>专家组在使用前共同为该操作评分。请尽量保持参考操作不变，使每位医师都用相同的操作校准。</translation>
    </message>
    <message>
        <source>Withdrawn: %1</source>
        <translation>已撤回：%1</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>使用中</translation>
    </message>
    <message>
        <source>Withdraw a reference run</source>
        <translation>撤回参考操作</translation>
    </message>
    <message>
        <source>Withdraw reference runs</source>
        <translation>撤回参考操作</translation>
    </message>
    <message numerus="yes">
        <source>No physician is given the chosen runs any more (%n). Marks given on them stay. A run that is withdrawn cannot be used for rater calibration again.</source>
        <translation>
            <numerusform>所选的 %n 个参考操作不再分给任何医师。已给出的评分保留。撤回后不能再用于评分校准。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Withdrawn from rater calibration: %n run(s)</source>
        <translation>
            <numerusform>已从评分校准中撤回 %n 个参考操作</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::RaterCalibrationPage</name>
    <message>
        <source>The recording could not be opened.</source>
        <translation>无法打开录制。</translation>
    </message>
    <message>
        <source>No reference run has been chosen yet. You may begin with your queue.</source>
        <translation>尚未选定参考操作，您可以直接从队列开始。</translation>
    </message>
    <message>
        <source>The recording is being opened. You may score meanwhile.</source>
        <translation>正在打开录制，您可以先评分。</translation>
    </message>
    <message>
        <source>Opening reference %1</source>
        <translation>正在打开参考录制 %1</translation>
    </message>
    <message>
        <source>Reference %1, scored</source>
        <translation>参考 %1，已评</translation>
    </message>
    <message>
        <source>Reference %1</source>
        <translation>参考 %1</translation>
    </message>
    <message>
        <source>&amp;Queue</source>
        <translation>待评列表(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Compare with the panel</source>
        <translation>与专家组比较(&amp;C)</translation>
    </message>
    <message>
        <source>Go on with reference %1</source>
        <translation>继续参考操作 %1</translation>
    </message>
    <message>
        <source>On to the queue</source>
        <translation>前往队列</translation>
    </message>
    <message>
        <source>Score first; then the panel&apos;s mark is shown.</source>
        <translation>请先评分，然后显示专家组的评分。</translation>
    </message>
    <message>
        <source>You: %1. Panel of %2: %3.</source>
        <translation>您：%1。%2 人专家组：%3。</translation>
    </message>
    <message>
        <source>That is as the panel sees it.</source>
        <translation>与专家组看法一致。</translation>
    </message>
    <message>
        <source>You are stricter by %1.</source>
        <translation>您严格了 %1 分。</translation>
    </message>
    <message>
        <source>You are milder by %1.</source>
        <translation>您宽松了 %1 分。</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Over all reference runs: %1 points from the panel. You may score a run again; every try is kept.</source>
        <translation>全部参考操作：与专家组相差 %1 分。您可以重新评分，每次尝试均保留。</translation>
    </message>
    <message>
        <source>You may score it again, or go on with the next run.</source>
        <translation>您可以重新评分，或继续下一个操作。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1。%2</translation>
    </message>
    <message>
        <source>Rater calibration</source>
        <translation>评分校准</translation>
    </message>
    <message>
        <source>Score the reference runs before the real cases and see your own offset from the panel. Nobody else sees it.</source>
        <translation>在正式评分之前先评参考操作，了解您与专家组的差距。其他人看不到。</translation>
    </message>
    <message>
        <source>Ctrl+Enter</source>
        <translation>Ctrl+Enter</translation>
    </message>
    <message>
        <source>Your offset</source>
        <translation>您的差距</translation>
    </message>
    <message>
        <source>What the rubric asks for</source>
        <translation>评分标准</translation>
    </message>
    <message>
        <source>Compare with the panel</source>
        <translation>与专家组比较</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ReadoutPanel</name>
    <message>
        <source>Twist</source>
        <translation>扭转</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>负荷</translation>
    </message>
    <message>
        <source>Timing</source>
        <translation>计时</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>阶段</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>扭矩</translation>
    </message>
    <message>
        <source>N m</source>
        <translation>N m</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Servo tick</source>
        <translation>伺服周期</translation>
    </message>
    <message>
        <source>Time that one step of the 1 kHz loop takes, of 1000 µs; how many steps came late</source>
        <translation>1 kHz 循环每一步所用时间（上限 1000 µs），以及延迟的步数</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>帧率</translation>
    </message>
    <message>
        <source>Pictures drawn in one second</source>
        <translation>每秒绘制的画面数</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>Twisting</source>
        <translation>扭转中</translation>
    </message>
    <message>
        <source>Released</source>
        <translation>已释放</translation>
    </message>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
    <message>
        <source>%1, too long</source>
        <translation>%1，过长</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n late</source>
        <translation>
            <numerusform>%1，延迟 %n 步</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 /s</source>
        <translation>%1 /秒</translation>
    </message>
    <message>
        <source>The tissue would have folded, so the jaw let go. Turn less far.</source>
        <translation>组织即将折叠，夹钳已松开。请少转一些。</translation>
    </message>
    <message>
        <source>The jaw slipped off: it was pulled too far. The tissue returns to rest.</source>
        <translation>夹钳滑脱：牵拉过度。组织正在复原。</translation>
    </message>
    <message>
        <source>The tissue returns to rest.</source>
        <translation>组织正在复原。</translation>
    </message>
    <message>
        <source>You are pressing too deep: draw back</source>
        <translation>压得过深：请退回</translation>
    </message>
</context>
<context>
    <name>torsio::gui::RemarkWords</name>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>修改</translation>
    </message>
    <message>
        <source>New words; the old ones are kept</source>
        <translation>新的文字；原文保留</translation>
    </message>
    <message>
        <source>edited %1</source>
        <translation>%1 修改</translation>
    </message>
    <message>
        <source>Shows what stood there before</source>
        <translation>显示修改之前的文字</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>torsio::gui::RemarksPage</name>
    <message>
        <source>What physicians wrote</source>
        <translation>医师的评语</translation>
    </message>
    <message>
        <source>Each remark stands at the second of the run that it concerns.</source>
        <translation>每条评语都标在操作中所涉及的那一秒。</translation>
    </message>
    <message>
        <source>No remarks yet. They appear here when the marks of a run have been released, or when a physician answers a question of yours.</source>
        <translation>尚无评语。当某次操作的评分公布后，或医师回答您的提问后，会显示在这里。</translation>
    </message>
    <message>
        <source>Remarks on this run</source>
        <translation>本次操作的评语</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>评分</translation>
    </message>
    <message>
        <source>Runs with remarks</source>
        <translation>有评语的操作</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>%1
%2, %3 not read</source>
        <translation>%1
%2，%3 条未读</translation>
    </message>
    <message>
        <source>%1
%2</source>
        <translation>%1
%2</translation>
    </message>
    <message>
        <source>You asked, at %1</source>
        <translation>您的提问，位于 %1</translation>
    </message>
    <message>
        <source>You, %1</source>
        <translation>您，%1</translation>
    </message>
    <message>
        <source>Physician, %1</source>
        <translation>医师，%1</translation>
    </message>
    <message>
        <source>Physician, at %1</source>
        <translation>医师，时刻 %1</translation>
    </message>
    <message>
        <source>Mark as read</source>
        <translation>标为已读</translation>
    </message>
    <message>
        <source>Look at the run</source>
        <translation>查看操作</translation>
    </message>
    <message>
        <source>About this moment</source>
        <translation>关于这一时刻</translation>
    </message>
    <message>
        <source>Write a reply</source>
        <translation>写回复</translation>
    </message>
    <message>
        <source>Reply</source>
        <translation>回复</translation>
    </message>
    <message>
        <source>Score yourself first; then you see the physicians&apos; marks.</source>
        <translation>请先自评，然后可以看到医师的评分。</translation>
    </message>
    <message>
        <source>Your marks are kept. The physicians&apos; marks appear when they are released.</source>
        <translation>您的自评已保存。医师评分发布后会显示。</translation>
    </message>
    <message>
        <source>You</source>
        <translation>自评</translation>
    </message>
    <message>
        <source>Physicians</source>
        <translation>医师</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>差值</translation>
    </message>
    <message>
        <source>Overall</source>
        <translation>总分</translation>
    </message>
    <message numerus="yes">
        <source>Your own marks beside the mean of %n physician(s).</source>
        <translation>
            <numerusform>您的自评与 %n 名医师平均评分的对比。</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Save my marks</source>
        <translation>保存自评(&amp;S)</translation>
    </message>
</context>
<context>
    <name>torsio::gui::RemindDialog</name>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>Reminders</source>
        <translation>提醒</translation>
    </message>
    <message>
        <source>Rater</source>
        <translation>评分者</translation>
    </message>
    <message>
        <source>Mail address</source>
        <translation>邮件地址</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>评分表</translation>
    </message>
    <message>
        <source>Late</source>
        <translation>逾期</translation>
    </message>
    <message>
        <source>Nobody owes a sheet.</source>
        <translation>没有人欠交评分表。</translation>
    </message>
    <message>
        <source>Each of the chosen raters gets a message with the labels of their own cases, and nothing else.</source>
        <translation>每位所选评分者收到一封邮件，其中只有本人案例的编号。</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>关闭(&amp;L)</translation>
    </message>
    <message>
        <source>none is known</source>
        <translation>没有地址</translation>
    </message>
    <message>
        <source>By %1, from %2</source>
        <translation>经由 %1，发件人 %2</translation>
    </message>
    <message>
        <source>The centre has set no mail server: set one, or copy the reminders into your own mail.</source>
        <translation>中心尚未设置邮件服务器：请设置，或将提醒复制到您自己的邮件中。</translation>
    </message>
    <message numerus="yes">
        <source>&amp;Send %n message(s)</source>
        <translation>
            <numerusform>发送 %n 封邮件(&amp;S)</numerusform>
        </translation>
    </message>
    <message>
        <source>Torsio: sheets to submit</source>
        <translation>Torsio：待提交的评分表</translation>
    </message>
    <message>
        <source>Sending reminders</source>
        <translation>正在发送提醒</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message numerus="yes">
        <source>✓ The mail server took %n message(s).</source>
        <translation>
            <numerusform>✓ 邮件服务器已接收 %n 封邮件。</numerusform>
        </translation>
    </message>
    <message>
        <source>! Not taken by the mail server:</source>
        <translation>! 邮件服务器未接收：</translation>
    </message>
    <message>
        <source>Mail ser&amp;ver…</source>
        <translation>邮件服务器(&amp;V)…</translation>
    </message>
    <message>
        <source>Pass&amp;word of the mail server</source>
        <translation>邮件服务器密码(&amp;W)</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ReplayBar</name>
    <message>
        <source>Close replay</source>
        <translation>关闭回放</translation>
    </message>
    <message>
        <source>Position in the recording</source>
        <translation>录制位置</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>%1 × speed</source>
        <translation>%1 倍速</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ReplayPanel</name>
    <message>
        <source>The organ in three dimensions</source>
        <translation>器官三维视图</translation>
    </message>
    <message>
        <source>5 s back</source>
        <translation>后退 5 秒</translation>
    </message>
    <message>
        <source>Jumps five seconds back (J)</source>
        <translation>后退五秒（J）</translation>
    </message>
    <message>
        <source>5 s on</source>
        <translation>前进 5 秒</translation>
    </message>
    <message>
        <source>Jumps five seconds on; what is skipped does not count as watched</source>
        <translation>前进五秒；跳过的部分不计入已观看</translation>
    </message>
    <message>
        <source>Plays or pauses (Space)</source>
        <translation>播放或暂停（空格）</translation>
    </message>
    <message>
        <source>Time in the recording</source>
        <translation>录制时间</translation>
    </message>
    <message>
        <source>Proves that this is the recording as it was stored. It tells nothing else, and it is another one for each physician</source>
        <translation>证明此录制与存储时一致。它不透露其他信息，且每位医师各不相同</translation>
    </message>
    <message>
        <source>The organ of this recording is not on this machine; the traces are complete.</source>
        <translation>本机没有此录制的器官模型；曲线是完整的。</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>%1 ×, locked</source>
        <translation>%1 ×，已锁定</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Scored recordings play as they happened</source>
        <translation>评分录制按原速播放</translation>
    </message>
    <message>
        <source>J slower, L faster; the speed is kept with the mark</source>
        <translation>J 减速，L 加速；速度随评分一并保存</translation>
    </message>
    <message>
        <source>Recording %1, unchanged</source>
        <translation>录制 %1，未改动</translation>
    </message>
    <message>
        <source>Undo the twist, then hands off</source>
        <translation>解除扭转，然后松手</translation>
    </message>
    <message>
        <source>Twist to %1° and let go within ±%2°</source>
        <translation>扭转至 %1°，在 ±%2° 内松开</translation>
    </message>
    <message>
        <source>hold for %1 s</source>
        <translation>保持 %1 秒</translation>
    </message>
    <message>
        <source>force up to %1 N</source>
        <translation>力不超过 %1 N</translation>
    </message>
    <message>
        <source>torque up to %1 N m</source>
        <translation>扭矩不超过 %1 N m</translation>
    </message>
    <message>
        <source>Asked for: %1</source>
        <translation>任务要求：%1</translation>
    </message>
    <message numerus="yes">
        <source>at least %n twist(s)</source>
        <translation>
            <numerusform>至少 %n 次扭转</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::RepliesCard</name>
    <message>
        <source>Answers to your remarks: %1</source>
        <translation>对您批注的回复：%1</translation>
    </message>
    <message>
        <source>Answers to your remarks</source>
        <translation>对您批注的回复</translation>
    </message>
    <message>
        <source>%1 (you wrote: %2)</source>
        <translation>%1（您写道：%2）</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>已读</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ReportsPage</name>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>as they are now</source>
        <translation>当前数据</translation>
    </message>
    <message>
        <source>Preparing the report</source>
        <translation>正在准备报告</translation>
    </message>
    <message>
        <source>This report will name the trainees. That you took it out is kept in the audit trail.</source>
        <translation>此报告将显示学员姓名。导出行为会记入审计记录。</translation>
    </message>
    <message>
        <source>The record has changed since this data set was frozen; the report says so.</source>
        <translation>该数据集冻结后记录已有变化；报告中会说明。</translation>
    </message>
    <message>
        <source>For a report that others rely on, freeze the data first: then anybody can check later that nothing changed.</source>
        <translation>正式报告请先冻结数据：以后任何人都能核对数据未被更改。</translation>
    </message>
    <message>
        <source>Freeze data</source>
        <translation>冻结数据</translation>
    </message>
    <message>
        <source>Name of the data set. It keeps a list of everything the report is made of, with hashes.</source>
        <translation>数据集名称。它保存报告所依据的全部内容及其哈希的清单。</translation>
    </message>
    <message>
        <source>Frozen as “%1”</source>
        <translation>已冻结为“%1”</translation>
    </message>
    <message>
        <source>Save report</source>
        <translation>保存报告</translation>
    </message>
    <message>
        <source>Save table of numbers</source>
        <translation>保存数据表</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Writing the report…</source>
        <translation>正在写入报告…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>Cancelled; no file was written</source>
        <translation>已取消；未写入文件</translation>
    </message>
    <message>
        <source>Reports</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Choose a cohort, freeze its data, look through the report, and write it.</source>
        <translation>选择批次，冻结数据，浏览报告，然后保存。</translation>
    </message>
    <message>
        <source>Save &amp;PDF…</source>
        <translation>保存 PDF(&amp;P)…</translation>
    </message>
    <message>
        <source>Save &amp;numbers (CSV)…</source>
        <translation>保存数据 (CSV)(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Cohort</source>
        <translation>批次(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Evaluation of models</source>
        <translation>模型评价(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Data</source>
        <translation>数据(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Freeze…</source>
        <translation>冻结(&amp;F)…</translation>
    </message>
    <message>
        <source>People are &amp;shown</source>
        <translation>人员显示(&amp;S)</translation>
    </message>
    <message>
        <source>by code</source>
        <translation>按代码</translation>
    </message>
    <message>
        <source>aggregated only</source>
        <translation>仅汇总</translation>
    </message>
    <message>
        <source>trainees with names</source>
        <translation>显示学员姓名</translation>
    </message>
    <message>
        <source>Preview of the report</source>
        <translation>报告预览</translation>
    </message>
    <message>
        <source>&amp;Language of the report</source>
        <translation>报告语言(&amp;L)</translation>
    </message>
    <message>
        <source>as the window</source>
        <translation>与窗口一致</translation>
    </message>
    <message>
        <source>Coded &amp;tables…</source>
        <translation>编码表格(&amp;T)…</translation>
    </message>
    <message>
        <source>Recordings and single marks under their codes, as far as you may see them</source>
        <translation>在您的权限内，以代码列出录制和单项评分</translation>
    </message>
    <message>
        <source>New folder for the tables</source>
        <translation>存放表格的新文件夹</translation>
    </message>
    <message>
        <source>tables-%1</source>
        <translation>表格-%1</translation>
    </message>
    <message>
        <source>Folder (*)</source>
        <translation>文件夹 (*)</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>导出(&amp;X)…</translation>
    </message>
    <message>
        <source>Recordings (%1) and marks (%2) written to %3</source>
        <translation>已将 %1 条录制和 %2 项评分写入 %3</translation>
    </message>
    <message>
        <source>Follow a numbe&amp;r…</source>
        <translation>追溯数值(&amp;R)…</translation>
    </message>
    <message>
        <source>Every number back to its marks, criteria, scoring sheet, recording and program. In the preview, press a number itself.</source>
        <translation>将每个数值追溯到其评分、评分项、评分标准、录制和程序。在预览中可直接点按数值。</translation>
    </message>
    <message>
        <source>Workbook, tables for SPSS and R, data sets, scores for a learning system; pseudonymised if wanted</source>
        <translation>工作簿、SPSS 与 R 表格、数据集、学习系统成绩；可按需假名化</translation>
    </message>
</context>
<context>
    <name>torsio::gui::RequestsDialog</name>
    <message>
        <source>Requests</source>
        <translation>申请</translation>
    </message>
    <message>
        <source>&amp;Confirm…</source>
        <translation>确认(&amp;C)…</translation>
    </message>
    <message>
        <source>What needs two people waits here for two weeks. Nobody confirms what they asked for themselves.</source>
        <translation>需要两人完成的事项在此等待两周。任何人都不能确认自己提出的申请。</translation>
    </message>
    <message>
        <source>What</source>
        <translation>事项</translation>
    </message>
    <message>
        <source>About</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>角色</translation>
    </message>
    <message>
        <source>Asked by</source>
        <translation>申请人</translation>
    </message>
    <message>
        <source>When</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>Nothing waits for a second person.</source>
        <translation>没有等待第二人确认的事项。</translation>
    </message>
    <message>
        <source>&amp;Take back…</source>
        <translation>撤回(&amp;T)…</translation>
    </message>
    <message>
        <source>&amp;Decline…</source>
        <translation>拒绝(&amp;D)…</translation>
    </message>
    <message>
        <source>Erase a person</source>
        <translation>删除一名人员</translation>
    </message>
    <message>
        <source>%1 asks to erase %2: “%3”. The identity is gone for good; marks stay under the code.</source>
        <translation>%1 申请删除 %2：“%3”。身份信息将永久消失；评分保留在代码之下。</translation>
    </message>
    <message>
        <source>&amp;Erase</source>
        <translation>删除(&amp;E)</translation>
    </message>
    <message>
        <source>%1 is erased</source>
        <translation>%1 已删除</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>%1 asks for this: “%2”. Do you know of it, and is it right?</source>
        <translation>%1 提出此申请：“%2”。您了解此事并认为正确吗？</translation>
    </message>
    <message>
        <source>&amp;Confirm</source>
        <translation>确认(&amp;C)</translation>
    </message>
    <message>
        <source>Sealing the start password</source>
        <translation>正在加密初始密码</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>撤回</translation>
    </message>
    <message>
        <source>Decline</source>
        <translation>拒绝</translation>
    </message>
    <message>
        <source>Choose the backup %1: restoring it confirms the request</source>
        <translation>请选择备份 %1：恢复它即为确认该申请</translation>
    </message>
    <message>
        <source>The keeper of the allocation opens it on this page: that confirms the request</source>
        <translation>由分组管理员在此页面启封：即为确认该申请</translation>
    </message>
    <message numerus="yes">
        <source>%1 asks for these %n account(s): %2. Do you know of them, and are they right? What is not about an account is confirmed by itself.</source>
        <translation>
            <numerusform>%1 申请了这 %n 个账户：%2。您是否知情，内容是否正确？与账户无关的申请需单独确认。</numerusform>
        </translation>
    </message>
    <message>
        <source>Sealing the start passwords</source>
        <translation>正在封存初始密码</translation>
    </message>
    <message numerus="yes">
        <source>%n request(s) are closed and stay in the audit trail.</source>
        <translation>
            <numerusform>%n 项申请将关闭，并保留在审计记录中。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 asks to invite %2. Do you know of it, and is it right? You get the links, and hand each to its person.</source>
        <translation>%1 申请邀请 %2 登录。您是否知情并同意？您将得到链接，请分别转交本人。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::RestorePage</name>
    <message>
        <source>Choose a backup</source>
        <translation>选择备份</translation>
    </message>
    <message>
        <source>Backup (*.sqlite)</source>
        <translation>备份 (*.sqlite)</translation>
    </message>
    <message>
        <source>Checking the backup</source>
        <translation>正在检查备份</translation>
    </message>
    <message>
        <source>Restoring the backup</source>
        <translation>正在恢复备份</translation>
    </message>
    <message>
        <source>The record was restored from %1. As it was before, it is kept in %2</source>
        <translation>记录已从 %1 恢复。恢复前的记录保存在 %2</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>In the backup</source>
        <translation>备份中</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>丢失</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>评分</translation>
    </message>
    <message>
        <source>People</source>
        <translation>人员</translation>
    </message>
    <message>
        <source>Newest recording or mark</source>
        <translation>最新的录制或评分</translation>
    </message>
    <message>
        <source>Nothing recorded is lost: the backup has every recording, mark and person of today.</source>
        <translation>不会丢失任何记录：备份包含今天的所有录制、评分和人员。</translation>
    </message>
    <message>
        <source>Passwords, accounts, settings and consents are those of the backup. Look at consents afterwards.</source>
        <translation>密码、账户、设置和知情同意将恢复为备份时的内容。请随后核对知情同意。</translation>
    </message>
    <message>
        <source>RESTORE</source>
        <translation>RESTORE</translation>
    </message>
    <message>
        <source>Restore from a backup</source>
        <translation>从备份恢复</translation>
    </message>
    <message>
        <source>The record of all people at all stations goes back to the day of the backup.</source>
        <translation>所有工作站、所有人员的记录都将回到备份当日的状态。</translation>
    </message>
    <message>
        <source>&amp;Back to maintenance</source>
        <translation>返回维护(&amp;B)</translation>
    </message>
    <message>
        <source>1  The backup</source>
        <translation>1  备份</translation>
    </message>
    <message>
        <source>It is first read from end to end in a copy; your record is not touched. Nobody may be at work: close Torsio at all other stations.</source>
        <translation>首先在副本中从头到尾读取备份，不会改动您的记录。此时不得有人使用：请关闭其他所有工作站上的 Torsio。</translation>
    </message>
    <message>
        <source>Backup &amp;file</source>
        <translation>备份文件(&amp;F)</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>选择(&amp;H)…</translation>
    </message>
    <message>
        <source>&amp;Check this backup</source>
        <translation>检查此备份(&amp;C)</translation>
    </message>
    <message>
        <source>2  What is kept and what is lost</source>
        <translation>2  保留与丢失的内容</translation>
    </message>
    <message>
        <source>3  Restore</source>
        <translation>3  恢复</translation>
    </message>
    <message>
        <source>A safety backup of the record as it is now is made first, beside the record. Then the backup takes its place, and everybody signs in again.</source>
        <translation>首先在记录旁边为当前记录做一份安全备份，然后用备份取代记录，所有人需重新登录。</translation>
    </message>
    <message>
        <source>&amp;Type %1 to go on</source>
        <translation>输入 %1 以继续(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Restore now</source>
        <translation>立即恢复(&amp;R)</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>! This is the backup of another centre: %1. The record of %2 would be gone from here.</source>
        <translation>! 这是另一中心的备份：%1。%2 的记录将不再保留于此。</translation>
    </message>
    <message>
        <source>Restore a backup</source>
        <translation>恢复备份</translation>
    </message>
    <message>
        <source>Why is it restored? Another administrator confirms it.</source>
        <translation>为什么要恢复？由另一位管理员确认。</translation>
    </message>
    <message>
        <source>What was added after the backup is no longer in the record: recordings %1, marks %2, people %3. It stays in the safety backup.</source>
        <translation>备份之后新增的内容将不再属于记录：%1 个录制、%2 个评分和 %3 名人员。它们仍保留在安全备份中。</translation>
    </message>
    <message numerus="yes">
        <source>Erased after this backup: %n person(s). They stay erased.</source>
        <translation>
            <numerusform>此备份之后有 %n 人被删除，恢复后仍保持删除。</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a backup, or type its path.</source>
        <translation>请选择备份，或输入其路径。</translation>
    </message>
    <message>
        <source>This is not yet the word: %1, with the same capitals.</source>
        <translation>与要求的文字不同：%1，区分大小写。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ResultsPage</name>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Computing results</source>
        <translation>正在计算结果</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Every figure of the report with its values. Ctrl+C copies what is shown.</source>
        <translation>报告的每幅图及其数值。Ctrl+C 复制当前内容。</translation>
    </message>
    <message>
        <source>&amp;Cohort</source>
        <translation>批次(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Evaluation of models</source>
        <translation>模型评价(&amp;E)</translation>
    </message>
    <message>
        <source>Figures and tables</source>
        <translation>图和表</translation>
    </message>
    <message>
        <source>There is nothing to show yet: no cohort has marks or recordings.</source>
        <translation>暂无内容：没有批次有评分或录制。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::RetentionQueue</name>
    <message>
        <source>to be reviewed</source>
        <translation>待审查</translation>
    </message>
    <message>
        <source>locked: %1</source>
        <translation>已锁定：%1</translation>
    </message>
    <message>
        <source>kept longer: %1</source>
        <translation>延长保存：%1</translation>
    </message>
    <message>
        <source>&amp;Release…</source>
        <translation>解除(&amp;R)…</translation>
    </message>
    <message>
        <source>&amp;Lock…</source>
        <translation>锁定(&amp;L)…</translation>
    </message>
    <message>
        <source>Keep longer</source>
        <translation>延长保存</translation>
    </message>
    <message numerus="yes">
        <source>Kept for another year: %n record(s), %1.</source>
        <translation>
            <numerusform>再保存一年：%n 份记录，%1。</numerusform>
        </translation>
    </message>
    <message>
        <source>Release</source>
        <translation>释放</translation>
    </message>
    <message numerus="yes">
        <source>No longer held: %n record(s), %1.</source>
        <translation>
            <numerusform>不再保留：%n 份记录，%1。</numerusform>
        </translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>锁定</translation>
    </message>
    <message numerus="yes">
        <source>Kept until somebody releases them: %n record(s), %1.</source>
        <translation>
            <numerusform>一直保留，直到有人解除：%n 份记录，%1。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The identities of %1 are erased for good, and %n recording(s) with them. Marks stay without a person, so that statistics remain right.</source>
        <translation>
            <numerusform>%1 的身份信息连同 %n 次录制将永久删除。评分去除个人信息后保留，以保证统计正确。</numerusform>
        </translation>
    </message>
    <message>
        <source>Backups and packages may still hold them: torsio db copies lists all.</source>
        <translation>备份和数据包中可能仍有这些人：用 torsio db copies 可列出全部。</translation>
    </message>
    <message>
        <source>Erase records</source>
        <translation>删除记录</translation>
    </message>
    <message>
        <source>Records due for review</source>
        <translation>到期待审查的记录</translation>
    </message>
    <message>
        <source>&amp;Keep longer…</source>
        <translation>延长保存(&amp;K)…</translation>
    </message>
    <message>
        <source>&amp;Erase…</source>
        <translation>删除(&amp;E)…</translation>
    </message>
    <message>
        <source>R&amp;ules…</source>
        <translation>规则(&amp;U)…</translation>
    </message>
    <message>
        <source>How long records are kept, and on what lawful basis</source>
        <translation>记录保存多久，依据何种法律依据</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>人员</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>Lawful basis</source>
        <translation>法律依据</translation>
    </message>
    <message>
        <source>Last activity</source>
        <translation>最近活动</translation>
    </message>
    <message>
        <source>Due since</source>
        <translation>到期时间</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>No record is due. Rules says after how long without activity a record is listed here.</source>
        <translation>没有到期的记录。“规则”规定记录无活动多久后列于此处。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ReviewDeskDialog</name>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Stays open when Torsio is closed here</source>
        <translation>在此关闭 Torsio 后仍保持开放(&amp;S)</translation>
    </message>
    <message>
        <source>Let physicians score from their browsers</source>
        <translation>让医师在自己的浏览器中评分</translation>
    </message>
    <message>
        <source>Physicians open the address in any browser of the hospital and score the same cases as at the desk; nothing is installed. Each needs an account, and comes in by an invitation (Users, Invite) or a password. This computer must stay on.</source>
        <translation>医师在院内任意浏览器中打开此地址，即可为与评分台相同的案例评分，无需安装任何软件。每人需有账户，凭邀请链接（用户页中的“邀请”）或密码进入。这台计算机须保持开机。</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Other computers of this network</source>
        <translation>本网络中的其他计算机</translation>
    </message>
    <message>
        <source>This computer alone</source>
        <translation>仅这台计算机</translation>
    </message>
    <message>
        <source>Made by Torsio</source>
        <translation>由 Torsio 生成</translation>
    </message>
    <message>
        <source>From files</source>
        <translation>来自文件</translation>
    </message>
    <message>
        <source>&amp;Who reaches it</source>
        <translation>谁可访问(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>端口(&amp;P)</translation>
    </message>
    <message>
        <source>C&amp;ertificate</source>
        <translation>证书(&amp;E)</translation>
    </message>
    <message>
        <source>Certificate with its chain (PEM)</source>
        <translation>证书及其证书链（PEM）</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>选择(&amp;H)…</translation>
    </message>
    <message>
        <source>Its key (PEM)</source>
        <translation>对应的密钥（PEM）</translation>
    </message>
    <message>
        <source>Choose &amp;key…</source>
        <translation>选择密钥(&amp;K)…</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>完成(&amp;D)</translation>
    </message>
    <message>
        <source>This record lies on a server. Whoever runs that opens the review desk there, by torsio serve; this window does not.</source>
        <translation>该记录库位于服务器上。由服务器管理者在服务器上用 torsio serve 开放评分台，不在此窗口开放。</translation>
    </message>
    <message>
        <source>The review desk is closed.</source>
        <translation>评分台未开放。</translation>
    </message>
    <message>
        <source>The review desk is open, and stays open when Torsio is closed here.</source>
        <translation>评分台已开放；在此关闭 Torsio 后仍保持开放。</translation>
    </message>
    <message>
        <source>The review desk is open, and closes with this window.</source>
        <translation>评分台已开放；关闭此窗口时随之关闭。</translation>
    </message>
    <message>
        <source>A browser that does not know the certificate asks once whether to trust it. It is the right one when its SHA-256 fingerprint is:
%1</source>
        <translation>浏览器若不认识此证书，会询问一次是否信任。若其 SHA-256 指纹如下，即为正确的证书：
%1</translation>
    </message>
    <message>
        <source>C&amp;lose the review desk</source>
        <translation>关闭评分台(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Open the review desk</source>
        <translation>开放评分台(&amp;O)</translation>
    </message>
    <message>
        <source>Opening the review desk</source>
        <translation>正在开放评分台</translation>
    </message>
    <message>
        <source>Closing the review desk</source>
        <translation>正在关闭评分台</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>已复制</translation>
    </message>
    <message>
        <source>Certificates and keys (*.pem *.crt *.key)</source>
        <translation>证书与密钥 (*.pem *.crt *.key)</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ReviewKeys</name>
    <message>
        <source>Give the selected row a mark; 1 and then 0 is ten</source>
        <translation>为选中的一项评分；先按 1 再按 0 为十分</translation>
    </message>
    <message>
        <source>Half a point less or more; with Shift the finest step</source>
        <translation>减或加半分；按住 Shift 为最小步长</translation>
    </message>
    <message>
        <source>Another row</source>
        <translation>其他项</translation>
    </message>
    <message>
        <source>Take the mark back</source>
        <translation>收回评分</translation>
    </message>
    <message>
        <source>Undo, redo</source>
        <translation>撤销、重做</translation>
    </message>
    <message>
        <source>Submit; a second time seals</source>
        <translation>提交；再按一次封存</translation>
    </message>
    <message>
        <source>Play, pause</source>
        <translation>播放、暂停</translation>
    </message>
    <message>
        <source>Five seconds back, pause, play</source>
        <translation>后退五秒、暂停、播放</translation>
    </message>
    <message>
        <source>One picture back, one picture on</source>
        <translation>后退一帧、前进一帧</translation>
    </message>
    <message>
        <source>Beginning, end of the recording</source>
        <translation>记录的开头、结尾</translation>
    </message>
</context>
<context>
    <name>torsio::gui::RosterColumnsPage</name>
    <message>
        <source>The columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>Which column holds what. Fields with a star are needed; the first lines of the file stand below.</source>
        <translation>指定各列的内容。带星号的字段为必填；下方为文件的前几行。</translation>
    </message>
    <message>
        <source>not in this file</source>
        <translation>文件中没有</translation>
    </message>
    <message>
        <source>%1 *</source>
        <translation>%1 *</translation>
    </message>
    <message>
        <source>Needed: choose its column, or add one to the file.</source>
        <translation>必填：请选择对应的列，或在文件中补上该列。</translation>
    </message>
    <message>
        <source>! The column %1 looks like the class of raters. If this file lists raters, go back and choose Raters.</source>
        <translation>！%1 列看起来是评分者的职级。如果此文件列出的是评分者，请返回并选择“评分者”。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::RosterFilePage</name>
    <message>
        <source>&amp;Trainees</source>
        <translation>学员(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Raters</source>
        <translation>评分者(&amp;R)</translation>
    </message>
    <message>
        <source>The file</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>A table saved as CSV (UTF-8), one person a line, with a header line. The staff or student number tells who somebody is; an e-mail address alone never does.</source>
        <translation>保存为 CSV (UTF-8) 的表格，每行一人，首行为表头。以工号或学号识别人员，仅凭电子邮箱不作识别。</translation>
    </message>
    <message>
        <source>Path of the CSV file</source>
        <translation>CSV 文件路径</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>选择(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Save an empty template…</source>
        <translation>保存空白模板(&amp;S)…</translation>
    </message>
    <message>
        <source>Needed columns: %1. Further columns, as far as you have them: %2. Their order and their headings do not matter; the next step asks which is which.</source>
        <translation>必需的列：%1。其他可有的列：%2。顺序和标题不限；下一步会询问各列含义。</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>Roster</source>
        <translation>人员名册</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt *.tsv);;All files (*)</source>
        <translation>表格 (*.csv *.txt *.tsv);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Empty template</source>
        <translation>空白模板</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Choose the file, or type its path.</source>
        <translation>请选择文件，或输入其路径。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::RosterImportsDialog</name>
    <message>
        <source>Imported rosters</source>
        <translation>已导入的名单</translation>
    </message>
    <message>
        <source>&amp;Take back…</source>
        <translation>撤回(&amp;T)…</translation>
    </message>
    <message>
        <source>A roster that was imported by mistake is taken back whole: whom it added goes, whom it changed is as before. That can be done while nothing hangs on its people.</source>
        <translation>误导入的名单可整体撤回：新增的人员被移除，被修改的人员恢复原样。只有在这些人员尚无任何相关记录时才能撤回。</translation>
    </message>
    <message>
        <source>Imported</source>
        <translation>导入时间</translation>
    </message>
    <message>
        <source>By</source>
        <translation>导入者</translation>
    </message>
    <message>
        <source>Lists</source>
        <translation>名单</translation>
    </message>
    <message>
        <source>Added</source>
        <translation>新增</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>修改</translation>
    </message>
    <message>
        <source>People</source>
        <translation>人员</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>No roster was imported yet.</source>
        <translation>尚未导入名单。</translation>
    </message>
    <message>
        <source>taken back</source>
        <translation>已撤回</translation>
    </message>
    <message>
        <source>can be taken back</source>
        <translation>可以撤回</translation>
    </message>
    <message>
        <source>trainees</source>
        <translation>学员</translation>
    </message>
    <message>
        <source>raters</source>
        <translation>评分者</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>撤回</translation>
    </message>
    <message>
        <source>People who go, with accounts that nobody used: %1. People who are as before: %2. Codes that were given are not given again.</source>
        <translation>将移除的人员（连同从未使用的账户）：%1。恢复原样的人员：%2。已分配的编号不会再次使用。</translation>
    </message>
    <message>
        <source>The import is taken back</source>
        <translation>已撤回导入</translation>
    </message>
</context>
<context>
    <name>torsio::gui::RosterPage</name>
    <message>
        <source>People</source>
        <translation>人员</translation>
    </message>
    <message>
        <source>Who trains and who scores. Everything else in the record knows them by their code only.</source>
        <translation>参加培训和评分的人员。记录的其他部分只使用其代码。</translation>
    </message>
    <message>
        <source>&amp;Import a roster…</source>
        <translation>导入名单(&amp;I)…</translation>
    </message>
    <message>
        <source>&amp;New person…</source>
        <translation>新建人员(&amp;N)…</translation>
    </message>
    <message>
        <source>Show na&amp;mes</source>
        <translation>显示姓名(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Change…</source>
        <translation>修改(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>代码</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Trains</source>
        <translation>参加培训</translation>
    </message>
    <message>
        <source>Scores as</source>
        <translation>评分身份</translation>
    </message>
    <message>
        <source>Sex</source>
        <translation>性别</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>Experience</source>
        <translation>经验</translation>
    </message>
    <message>
        <source>Consent to the record</source>
        <translation>同意记录</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Nobody yet. Import the roster of your centre, or add people by hand.</source>
        <translation>尚无人员。请导入本中心的名单，或手动添加人员。</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>given</source>
        <translation>已同意</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>未同意</translation>
    </message>
    <message>
        <source>active</source>
        <translation>在册</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左手</translation>
    </message>
    <message>
        <source>Came &amp;back…</source>
        <translation>已返回(&amp;B)…</translation>
    </message>
    <message>
        <source>Has &amp;left…</source>
        <translation>已离开(&amp;L)…</translation>
    </message>
    <message>
        <source>%1 people added, %2 changed</source>
        <translation>已添加 %1 人，修改 %2 人</translation>
    </message>
    <message>
        <source>Has left</source>
        <translation>已离开</translation>
    </message>
    <message>
        <source>%1 keeps the record and is offered nowhere any more.</source>
        <translation>%1 的记录保留，但不再出现在选择列表中。</translation>
    </message>
    <message>
        <source>Came back</source>
        <translation>已返回</translation>
    </message>
    <message>
        <source>%1 is offered again.</source>
        <translation>%1 重新出现在选择列表中。</translation>
    </message>
    <message>
        <source>Export with names</source>
        <translation>含姓名导出</translation>
    </message>
    <message>
        <source>Export under codes</source>
        <translation>仅以代码导出</translation>
    </message>
    <message>
        <source>Exporting people</source>
        <translation>正在导出人员</translation>
    </message>
    <message>
        <source>%1 people written to %2</source>
        <translation>已将 %1 人写入 %2</translation>
    </message>
    <message>
        <source>Export this person’s recor&amp;d…</source>
        <translation>导出此人的记录(&amp;D)…</translation>
    </message>
    <message>
        <source>Everything the record holds about one person, for themselves</source>
        <translation>记录中有关此人的全部内容，供其本人使用</translation>
    </message>
    <message>
        <source>Erase on re&amp;quest…</source>
        <translation>应要求删除(&amp;Q)…</translation>
    </message>
    <message>
        <source>Export this person’s record</source>
        <translation>导出此人的记录</translation>
    </message>
    <message>
        <source>A new folder takes everything about %1: tables, recordings and a list of all files. It holds the name; hand it to nobody else.</source>
        <translation>新文件夹将包含有关 %1 的全部内容：表格、录制和文件清单。其中含有姓名，请勿交给他人。</translation>
    </message>
    <message>
        <source>New folder for the record of %1</source>
        <translation>存放 %1 记录的新文件夹</translation>
    </message>
    <message>
        <source>Folder (*)</source>
        <translation>文件夹 (*)</translation>
    </message>
    <message>
        <source>Exporting a record</source>
        <translation>正在导出记录</translation>
    </message>
    <message>
        <source>Erase on request</source>
        <translation>应要求删除</translation>
    </message>
    <message>
        <source>Name, number and recordings of %1 are erased for good. Marks stay without a person, so that statistics remain right. This cannot be taken back.</source>
        <translation>%1 的姓名、编号和录制将被永久删除。评分会保留但不再关联到个人，以保证统计正确。此操作无法撤销。</translation>
    </message>
    <message>
        <source>The record is erased</source>
        <translation>记录已删除</translation>
    </message>
    <message>
        <source>C&amp;onsents…</source>
        <translation>知情同意(&amp;O)…</translation>
    </message>
    <message>
        <source>Consent &amp;texts…</source>
        <translation>知情同意文本(&amp;T)…</translation>
    </message>
    <message>
        <source>Tables (%1) and recordings (%2) written to %3</source>
        <translation>已将 %1 个表格和 %2 个录制写入 %3</translation>
    </message>
    <message>
        <source>Request&amp;s…</source>
        <translation>申请(&amp;S)…</translation>
    </message>
    <message>
        <source>Request&amp;s (%1)…</source>
        <translation>申请 (%1)(&amp;S)…</translation>
    </message>
    <message>
        <source>What trainees asked for about their own record</source>
        <translation>学员就本人记录提出的申请</translation>
    </message>
    <message>
        <source>&amp;Undo an import…</source>
        <translation>撤回导入(&amp;U)…</translation>
    </message>
</context>
<context>
    <name>torsio::gui::RosterPreviewPage</name>
    <message>
        <source>What would happen</source>
        <translation>导入预览</translation>
    </message>
    <message>
        <source>Nothing is stored yet. With an error in any line nothing at all is imported: mend the file and choose it again.</source>
        <translation>尚未保存任何内容。只要有一行出错就不会导入，请修正文件后重新选择。</translation>
    </message>
    <message>
        <source>How far it has come</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>%1: %2 %</source>
        <translation>%1：%2 %</translation>
    </message>
    <message>
        <source>Looking at the roster</source>
        <translation>正在查看名单</translation>
    </message>
    <message>
        <source>%1 new, %2 with changes, %3 as they are, %4 with errors.</source>
        <translation>新增 %1，更改 %2，不变 %3，错误 %4。</translation>
    </message>
    <message>
        <source>Importing…</source>
        <translation>正在导入…</translation>
    </message>
    <message>
        <source>Importing the roster</source>
        <translation>正在导入名单</translation>
    </message>
    <message>
        <source>The file was read as %1: look at letters with accents.</source>
        <translation>文件按 %1 编码读取：请检查带重音符号的字母。</translation>
    </message>
    <message numerus="yes">
        <source>Comparing %n line(s) with the record…</source>
        <translation>
            <numerusform>正在将 %n 行与记录比较…</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::RosterWizard</name>
    <message>
        <source>Import a roster</source>
        <translation>导入名单</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>导入(&amp;I)</translation>
    </message>
    <message>
        <source>&lt; &amp;Back</source>
        <translation>&lt; 上一步(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Next &gt;</source>
        <translation>下一步(&amp;N) &gt;</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>torsio::gui::RubricDialog</name>
    <message>
        <source>&amp;Import…</source>
        <translation>导入(&amp;I)…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Publish…</source>
        <translation>发布(&amp;P)…</translation>
    </message>
    <message>
        <source>Import a scoring sheet</source>
        <translation>导入评分表</translation>
    </message>
    <message>
        <source>Scoring sheet (*.json)</source>
        <translation>评分表 (*.json)</translation>
    </message>
    <message>
        <source>Export the scoring sheet</source>
        <translation>导出评分表</translation>
    </message>
    <message>
        <source>%1, revision %2</source>
        <translation>%1，修订版 %2</translation>
    </message>
    <message>
        <source>&amp;Revision</source>
        <translation>修订版(&amp;R)</translation>
    </message>
    <message>
        <source>A change becomes the next revision, for raters who are asked from then on. Sheets that were asked for keep theirs.</source>
        <translation>每次修改都成为下一修订版，供此后被邀请的评分人使用。已分派的评分表保留其修订版。</translation>
    </message>
    <message>
        <source>As the rater sees it</source>
        <translation>评分人看到的样子</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>关闭(&amp;L)</translation>
    </message>
    <message>
        <source>Scoring sheet: %1</source>
        <translation>评分表：%1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Publish</source>
        <translation>发布</translation>
    </message>
    <message>
        <source>Raters who are asked from now on fill in this sheet. Sheets that were asked for before stay as they are; every revision is kept for good. What has changed?</source>
        <translation>今后被邀请的评分人填写此评分表。此前分派的评分表保持不变；每个修订版都永久保留。改动了什么？</translation>
    </message>
    <message>
        <source>%1: revision %2 is used from now on</source>
        <translation>%1：今后使用修订版 %2</translation>
    </message>
    <message>
        <source>Close without publishing</source>
        <translation>不发布就关闭</translation>
    </message>
    <message>
        <source>The changes are not published and will be lost.</source>
        <translation>改动尚未发布，将会丢失。</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>放弃改动(&amp;D)</translation>
    </message>
</context>
<context>
    <name>torsio::gui::RubricForm</name>
    <message>
        <source>Add an a&amp;nchor</source>
        <translation>添加锚点(&amp;N)</translation>
    </message>
    <message>
        <source>Remove the anc&amp;hor</source>
        <translation>删除锚点(&amp;H)</translation>
    </message>
    <message>
        <source>Criteria</source>
        <translation>评分项</translation>
    </message>
    <message>
        <source>Overall mark</source>
        <translation>总分</translation>
    </message>
    <message>
        <source>&amp;Criterion</source>
        <translation>评分项(&amp;C)</translation>
    </message>
    <message>
        <source>In the mean of the criteria, which the coded tables show beside the overall mark; 0 leaves it out</source>
        <translation>用于评分项均值，编码数据表在总分旁列出该均值；0 表示不计入</translation>
    </message>
    <message>
        <source>&amp;Weight</source>
        <translation>权重(&amp;W)</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>分值</translation>
    </message>
    <message>
        <source>What it means</source>
        <translation>含义</translation>
    </message>
    <message>
        <source>&amp;Anchors</source>
        <translation>锚点(&amp;A)</translation>
    </message>
    <message>
        <source>(no name)</source>
        <translation>（无名称）</translation>
    </message>
    <message>
        <source>New criterion</source>
        <translation>新评分项</translation>
    </message>
    <message>
        <source>what this mark means</source>
        <translation>此分值的含义</translation>
    </message>
</context>
<context>
    <name>torsio::gui::RunDayPage</name>
    <message>
        <source>withdrew</source>
        <translation>已退出</translation>
    </message>
    <message>
        <source>all phases done</source>
        <translation>全部阶段已完成</translation>
    </message>
    <message>
        <source>no curriculum</source>
        <translation>无课程</translation>
    </message>
    <message>
        <source>records at %1</source>
        <translation>在 %1 录制</translation>
    </message>
    <message>
        <source>Nothing to run yet. Go through the pages at the left in their order: Roster (bring people in), Curricula, Cohorts, Allocation, Scoring.</source>
        <translation>尚无可运行的内容。请按左侧顺序进行：名册（录入人员）、课程、批次、分组、评分。</translation>
    </message>
    <message>
        <source>Nobody is enrolled in this cohort yet. Enrol trainees under Cohorts.</source>
        <translation>该批次尚无人登记。请在“批次”中登记学员。</translation>
    </message>
    <message>
        <source>! does not answer</source>
        <translation>! 无响应</translation>
    </message>
    <message>
        <source>● records</source>
        <translation>● 记录中</translation>
    </message>
    <message>
        <source>○ free</source>
        <translation>○ 空闲</translation>
    </message>
    <message>
        <source>Swapped; both deviations are noted.</source>
        <translation>已互换；双方的方案偏离均已记录。</translation>
    </message>
    <message>
        <source>&amp;Back in…</source>
        <translation>恢复(&amp;B)…</translation>
    </message>
    <message>
        <source>&amp;Withdraw…</source>
        <translation>退出(&amp;W)…</translation>
    </message>
    <message>
        <source>the whole cohort</source>
        <translation>整个批次</translation>
    </message>
    <message>
        <source>Back into the study</source>
        <translation>重新加入研究</translation>
    </message>
    <message>
        <source>%1 takes part again.</source>
        <translation>%1 重新参加。</translation>
    </message>
    <message>
        <source>Withdraw from the study</source>
        <translation>退出研究</translation>
    </message>
    <message>
        <source>%1 trains no further; what was recorded stays.</source>
        <translation>%1 不再训练；已有记录保留。</translation>
    </message>
    <message>
        <source>&amp;Cohort</source>
        <translation>批次(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Log time…</source>
        <translation>登记时间(&amp;L)…</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>工作站</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>现在</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>学员</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>阶段</translation>
    </message>
    <message>
        <source>For</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>版本</translation>
    </message>
    <message>
        <source>&amp;Deviation…</source>
        <translation>方案偏离(&amp;D)…</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>组别</translation>
    </message>
    <message>
        <source>Now at</source>
        <translation>当前阶段</translation>
    </message>
    <message>
        <source>Time left</source>
        <translation>剩余时间</translation>
    </message>
    <message>
        <source>Rest left</source>
        <translation>剩余休息</translation>
    </message>
    <message>
        <source>Scoring due</source>
        <translation>待评分时点</translation>
    </message>
    <message>
        <source>Sheets missing</source>
        <translation>缺评分表</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>方案偏离</translation>
    </message>
    <message>
        <source>○ not checked yet</source>
        <translation>○ 尚未检查</translation>
    </message>
    <message>
        <source>○ not checked today, last on %1</source>
        <translation>○ 今天尚未检查，上次为 %1</translation>
    </message>
    <message>
        <source>✓ fit at %1</source>
        <translation>✓ %1 检查：可用</translation>
    </message>
    <message>
        <source>! practice only at %1: %2</source>
        <translation>! %1 检查：仅供练习，%2</translation>
    </message>
    <message>
        <source>✗ not fit at %1: %2</source>
        <translation>✗ %1 检查：不可用，%2</translation>
    </message>
    <message>
        <source>Who is at what, what is left, which sheets are missing, and whether the devices are fit.</source>
        <translation>谁在做什么、还剩多少、缺哪些评分表、设备是否可用。</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Device check</source>
        <translation>设备检查</translation>
    </message>
    <message>
        <source>&amp;Noted…</source>
        <translation>已记录(&amp;N)…</translation>
    </message>
    <message>
        <source>All deviations of this cohort</source>
        <translation>本批次的全部方案偏离</translation>
    </message>
    <message>
        <source>Call to the arm</source>
        <translation>呼叫到手臂</translation>
    </message>
    <message>
        <source>On &amp;paper</source>
        <translation>纸质(&amp;P)</translation>
    </message>
    <message>
        <source>Print the call list…</source>
        <translation>打印呼叫名单…</translation>
    </message>
    <message>
        <source>Print sheets for the raters…</source>
        <translation>打印评分者用表…</translation>
    </message>
    <message>
        <source>Of the chosen trainee; without one, of everybody whose scoring is due</source>
        <translation>所选学员的；未选时为所有待评分学员的</translation>
    </message>
    <message>
        <source>Type sheets in…</source>
        <translation>录入纸质评分表…</translation>
    </message>
    <message>
        <source>Copy who owes which sheet</source>
        <translation>复制欠交名单</translation>
    </message>
    <message>
        <source>Print the call list</source>
        <translation>打印呼叫名单</translation>
    </message>
    <message>
        <source>Call list %1.pdf</source>
        <translation>呼叫名单 %1.pdf</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message numerus="yes">
        <source>Written: %n trainee(s) to call</source>
        <translation>
            <numerusform>已写入：待呼叫学员 %n 名</numerusform>
        </translation>
    </message>
    <message>
        <source>No live sheet is missing for what is chosen.</source>
        <translation>所选范围内没有缺少的现场评分表。</translation>
    </message>
    <message>
        <source>Print sheets on paper</source>
        <translation>打印纸质评分表</translation>
    </message>
    <message>
        <source>Sheets %1.pdf</source>
        <translation>评分表 %1.pdf</translation>
    </message>
    <message numerus="yes">
        <source>Written: %n sheet(s), a page each</source>
        <translation>
            <numerusform>已写入：%n 份评分表，每份一页</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 recording now · %2 of %3 done · sheets missing: %4</source>
        <translation>正在录制 %1 · 已完成 %2 / %3 · 缺评分表 %4</translation>
    </message>
    <message>
        <source>Today&apos;s sessions</source>
        <translation>今日训练</translation>
    </message>
    <message>
        <source>Last seen</source>
        <translation>最近在线</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Plan the da&amp;y…</source>
        <translation>安排当日(&amp;Y)…</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>已安排</translation>
    </message>
    <message>
        <source>no group yet</source>
        <translation>尚未分组</translation>
    </message>
    <message>
        <source>! %1, overdue</source>
        <translation>! %1，已逾期</translation>
    </message>
    <message>
        <source>Swap t&amp;urns…</source>
        <translation>互换顺序(&amp;U)…</translation>
    </message>
    <message>
        <source>Stations: %1 · recording: %2 · not answering: %3</source>
        <translation>工作站：%1 · 正在录制：%2 · 无应答：%3</translation>
    </message>
</context>
<context>
    <name>torsio::gui::RunPage</name>
    <message>
        <source>The haptic device was lost</source>
        <translation>力反馈设备已断开</translation>
    </message>
    <message>
        <source>%1. You go on with mouse and keyboard</source>
        <translation>%1。您可用鼠标和键盘继续</translation>
    </message>
    <message>
        <source>The haptic device was lost: the graded run has ended</source>
        <translation>力反馈设备已断开：计分操作已结束</translation>
    </message>
    <message>
        <source>What was recorded is kept as interrupted, and no attempt was used. Check the device, then begin again</source>
        <translation>已记录的内容作为中断保留，未消耗次数。请检查设备后重新开始</translation>
    </message>
    <message>
        <source>The computer stood still. That time does not count.</source>
        <translation>计算机曾停顿，这段时间不计入。</translation>
    </message>
    <message>
        <source>The rest is used up. Training goes on.</source>
        <translation>休息时间已用完，训练继续。</translation>
    </message>
    <message>
        <source>The time on the real arm is over. It has been logged.</source>
        <translation>实物手臂训练时间结束，已记录。</translation>
    </message>
    <message>
        <source>End this run now?</source>
        <translation>现在结束本次操作？</translation>
    </message>
    <message>
        <source>What was recorded is kept, and the attempt counts.</source>
        <translation>已记录的内容会保存，并计入一次尝试。</translation>
    </message>
    <message>
        <source>What was recorded is kept.</source>
        <translation>已记录的内容会保存。</translation>
    </message>
    <message>
        <source>&amp;End the run</source>
        <translation>结束操作(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>继续(&amp;G)</translation>
    </message>
    <message>
        <source>A run goes on. End it first.</source>
        <translation>操作正在进行，请先结束。</translation>
    </message>
    <message>
        <source>Time left</source>
        <translation>剩余时间</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Load on the tissue</source>
        <translation>组织受力</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>扭矩</translation>
    </message>
    <message>
        <source>N m</source>
        <translation>N m</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Graded run</source>
        <translation>计分操作</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>练习</translation>
    </message>
    <message>
        <source>Your run is safe</source>
        <translation>您的操作已妥善保存</translation>
    </message>
    <message>
        <source>No run goes on</source>
        <translation>没有正在进行的操作</translation>
    </message>
    <message>
        <source>Choose a module on the page “My next step”.</source>
        <translation>请在“我的下一步”页面选择模块。</translation>
    </message>
    <message>
        <source>Phase %1 of %2: %3</source>
        <translation>第 %1 / %2 阶段：%3</translation>
    </message>
    <message>
        <source>&amp;Rest (%1 left)</source>
        <translation>休息（剩余 %1）(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Rest (used up)</source>
        <translation>休息（已用完）(&amp;R)</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>休息</translation>
    </message>
    <message>
        <source>Your training clock stands still. Training goes on by itself when the rest is used up.</source>
        <translation>训练计时已暂停。休息时间用完后训练自动继续。</translation>
    </message>
    <message>
        <source>&amp;Go on now</source>
        <translation>现在继续(&amp;G)</translation>
    </message>
    <message>
        <source>Go to the real arm</source>
        <translation>请到实物手臂处</translation>
    </message>
    <message>
        <source>Come to the simulator</source>
        <translation>请回到模拟器</translation>
    </message>
    <message>
        <source>The next phase starts by itself: %1</source>
        <translation>下一阶段将自动开始：%1</translation>
    </message>
    <message>
        <source>I am &amp;ready</source>
        <translation>我准备好了(&amp;R)</translation>
    </message>
    <message>
        <source>Train on the real arm</source>
        <translation>在实物手臂上训练</translation>
    </message>
    <message>
        <source>Bring the jaw to the marked band.</source>
        <translation>将钳口移到标记带。</translation>
    </message>
    <message>
        <source>Bring the jaw to the marked band. The wheel moves it nearer.</source>
        <translation>将钳口移到标记的环带处。滚轮可使其靠近。</translation>
    </message>
    <message>
        <source>Touching. Close the jaw.</source>
        <translation>已接触，请夹紧。</translation>
    </message>
    <message>
        <source>Touching. Close the jaw: hold the left button or Space.</source>
        <translation>已接触。闭合钳口：按住左键或空格键。</translation>
    </message>
    <message>
        <source>On target. Hold, then let go gently.</source>
        <translation>已到目标。保持，然后轻轻松开。</translation>
    </message>
    <message>
        <source>On target. Let go gently.</source>
        <translation>已到目标。轻轻松开。</translation>
    </message>
    <message>
        <source>Beyond the target. Turn back a little.</source>
        <translation>超过目标，请稍微转回。</translation>
    </message>
    <message>
        <source>Nearly there. Slow down.</source>
        <translation>快到了，请放慢。</translation>
    </message>
    <message>
        <source>Turn in one even movement.</source>
        <translation>一次平稳地转动。</translation>
    </message>
    <message>
        <source>Above the limit: ease off</source>
        <translation>超过限值：请减力</translation>
    </message>
    <message>
        <source>The haptic device did not answer</source>
        <translation>力反馈设备没有响应</translation>
    </message>
    <message>
        <source>Check its cable and its power</source>
        <translation>请检查其电缆和电源</translation>
    </message>
    <message>
        <source>The haptic device is not ready: the graded run did not begin</source>
        <translation>力反馈设备未就绪：计分操作没有开始</translation>
    </message>
    <message>
        <source>No attempt was used. Check the device, then begin again</source>
        <translation>未计入尝试次数。请检查设备，然后重新开始</translation>
    </message>
    <message>
        <source>Getting the haptic device ready</source>
        <translation>正在准备力反馈设备</translation>
    </message>
    <message>
        <source>This takes a few seconds. Your time has not begun yet.</source>
        <translation>需要几秒钟。计时尚未开始。</translation>
    </message>
    <message>
        <source>This takes a few seconds. Your training clock stands still.</source>
        <translation>需要几秒钟。训练计时已暂停。</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>You are pressing too deep: draw back</source>
        <translation>压得过深：请退回</translation>
    </message>
    <message>
        <source>Not scored yet</source>
        <translation>尚未评分</translation>
    </message>
    <message>
        <source>Begin nevertheless</source>
        <translation>仍然开始</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message numerus="yes">
        <source>Only %1 of %n sheet(s) of this occasion are in, and the others cannot be made up for once the training goes on. Fetch the study team. Why does the training begin nevertheless? It is noted as a deviation.</source>
        <translation>
            <numerusform>该时点的 %n 份评分表只收到 %1 份，训练继续后将无法补评。请联系研究人员。为何仍要开始训练？这将记录为方案偏离。</numerusform>
        </translation>
    </message>
    <message>
        <source>The database did not answer. The recording is kept, on this computer where need be; as soon as the database answers you find its debrief on the page “Debrief”.</source>
        <translation>数据库无响应。录制已保留，必要时保存在本机；数据库恢复后，您可在“训练复盘”页面查看。</translation>
    </message>
    <message>
        <source>Turn in the opposite direction.</source>
        <translation>请向相反方向转动。</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n twist(s)</source>
        <translation>
            <numerusform>扭转 %1 / %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Guide me</source>
        <translation>引导我</translation>
    </message>
    <message>
        <source>This timer logs your training time. The tracker records the instrument.</source>
        <translation>此计时器记录您的训练时间。跟踪器正在记录器械。</translation>
    </message>
    <message>
        <source>This timer logs your training time. Nothing is recorded.</source>
        <translation>此计时器记录您的训练时间。不作其他记录。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ScaleFields</name>
    <message>
        <source>&amp;From</source>
        <translation>从(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;to</source>
        <translation>到(&amp;T)</translation>
    </message>
    <message>
        <source>in &amp;steps of</source>
        <translation>步长(&amp;S)</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ScanPanel</name>
    <message>
        <source>%1 mm left, %2 back, %3 up: value %4</source>
        <translation>左 %1 mm，后 %2，上 %3：值 %4</translation>
    </message>
    <message>
        <source>The mask holds %1 ml</source>
        <translation>掩膜体积 %1 ml</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>轴位</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>冠状位</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>矢状位</translation>
    </message>
    <message>
        <source>Wheel or arrow keys: other slices. Right drag: window of grey</source>
        <translation>滚轮或方向键：切换切片。右键拖动：调整灰度窗</translation>
    </message>
    <message>
        <source>What the organ is</source>
        <translation>器官是什么</translation>
    </message>
    <message>
        <source>&amp;Tissue</source>
        <translation>组织(&amp;T)</translation>
    </message>
    <message>
        <source>All within the skin</source>
        <translation>皮肤以内的全部</translation>
    </message>
    <message>
        <source>Gas in a hollow organ</source>
        <translation>空腔器官内的气体</translation>
    </message>
    <message>
        <source>Gas and the wall round it</source>
        <translation>气体及其周围的壁</translation>
    </message>
    <message>
        <source>A label of a mask</source>
        <translation>掩膜的一个标签</translation>
    </message>
    <message>
        <source>&amp;Number of the label</source>
        <translation>标签编号(&amp;N)</translation>
    </message>
    <message>
        <source>What a click does</source>
        <translation>点击的作用</translation>
    </message>
    <message>
        <source>Look there</source>
        <translation>查看该处</translation>
    </message>
    <message>
        <source>Seed: the organ lies there</source>
        <translation>种子：器官在该处</translation>
    </message>
    <message>
        <source>Box: drag round the organ</source>
        <translation>框：围绕器官拖动</translation>
    </message>
    <message>
        <source>Brush: add to the mask</source>
        <translation>画笔：加入掩膜</translation>
    </message>
    <message>
        <source>Brush: erase from the mask</source>
        <translation>画笔：从掩膜擦除</translation>
    </message>
    <message>
        <source>&amp;Radius of the brush</source>
        <translation>画笔半径(&amp;R)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Undo stroke</source>
        <translation>撤销笔画</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清空</translation>
    </message>
    <message>
        <source>Forgets seed, box and all strokes of the brush</source>
        <translation>清除种子、框和画笔的全部笔画</translation>
    </message>
    <message>
        <source>Window of grey</source>
        <translation>灰度窗</translation>
    </message>
    <message>
        <source>&amp;Preset</source>
        <translation>预设(&amp;P)</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>软组织</translation>
    </message>
    <message>
        <source>Gas and lung</source>
        <translation>气体与肺</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>骨</translation>
    </message>
    <message>
        <source>All values</source>
        <translation>全部数值</translation>
    </message>
    <message>
        <source>&amp;Level</source>
        <translation>窗位(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>窗宽(&amp;W)</translation>
    </message>
    <message>
        <source>Another file</source>
        <translation>另一个文件</translation>
    </message>
    <message>
        <source>Find the organ</source>
        <translation>寻找器官</translation>
    </message>
    <message>
        <source>Make its surface</source>
        <translation>生成曲面</translation>
    </message>
    <message>
        <source>with the fluid below the gas</source>
        <translation>连同气体下方的液体</translation>
    </message>
</context>
<context>
    <name>torsio::gui::SceneCanvas</name>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
</context>
<context>
    <name>torsio::gui::SceneView</name>
    <message>
        <source>This display cannot show the organ: it has no OpenGL.</source>
        <translation>此显示环境没有 OpenGL，无法显示器官。</translation>
    </message>
    <message>
        <source>Organ and instrument</source>
        <translation>器官与器械</translation>
    </message>
    <message>
        <source>Three-dimensional view; the numbers beside it say the same in text.</source>
        <translation>三维视图；旁边的数字以文字给出相同内容。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ScoreRow</name>
    <message>
        <source>Why can this not be judged? Enter ends, Esc takes it back</source>
        <translation>为什么无法评判？回车结束，Esc 撤回</translation>
    </message>
    <message>
        <source>Why %1 cannot be judged</source>
        <translation>%1 为什么无法评判</translation>
    </message>
    <message>
        <source>not assessable</source>
        <translation>无法评判</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>%1; now %2</source>
        <translation>%1；现为 %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ScoringPage</name>
    <message>
        <source>Trainee</source>
        <translation>学员</translation>
    </message>
    <message>
        <source>Occasion</source>
        <translation>评分时点</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>缺</translation>
    </message>
    <message>
        <source>not asked</source>
        <translation>未邀请</translation>
    </message>
    <message>
        <source>case %1: %2</source>
        <translation>案例 %1：%2</translation>
    </message>
    <message>
        <source>● submitted %1 · ○ open or ◐ draft %2</source>
        <translation>● 已提交 %1 · ○ 未开始或 ◐ 草稿 %2</translation>
    </message>
    <message>
        <source>Ad&amp;judicator (%1)…</source>
        <translation>仲裁评分者（%1）(&amp;J)…</translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s) asked for</source>
        <translation>
            <numerusform>已发出 %n 份评分表</numerusform>
        </translation>
    </message>
    <message>
        <source>The adjudicator finds the case in their queue</source>
        <translation>仲裁评分者会在自己的队列中看到该案例</translation>
    </message>
    <message>
        <source>Scoring</source>
        <translation>评分</translation>
    </message>
    <message>
        <source>Who scores whom, and how far it has come. Marks are not shown here.</source>
        <translation>谁为谁评分、进展如何。此处不显示评分。</translation>
    </message>
    <message>
        <source>Rater cali&amp;bration…</source>
        <translation>评分校准(&amp;B)…</translation>
    </message>
    <message>
        <source>The reference runs that every physician scores first</source>
        <translation>每位医师首先评分的参考操作</translation>
    </message>
    <message>
        <source>Physicians could not agree and ask for one more</source>
        <translation>医师意见不一，请求再加一位</translation>
    </message>
    <message>
        <source>&amp;Cohort</source>
        <translation>批次(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Reassign…</source>
        <translation>改派(&amp;R)…</translation>
    </message>
    <message>
        <source>Re&amp;lease marks…</source>
        <translation>公布评分(&amp;L)…</translation>
    </message>
    <message>
        <source>Scoring &amp;sheet…</source>
        <translation>评分表(&amp;S)…</translation>
    </message>
    <message>
        <source>%1, due %2</source>
        <translation>%1，截止 %2</translation>
    </message>
    <message>
        <source>Copy re&amp;minders</source>
        <translation>复制提醒(&amp;M)</translation>
    </message>
    <message>
        <source>Whom to remind of which cases, as a text for your mail</source>
        <translation>需提醒哪些人提交哪些案例，可直接粘贴到邮件</translation>
    </message>
    <message>
        <source>What raters fill in: criteria, scales, anchors and weights</source>
        <translation>评分人填写的内容：评分项、量程、锚点和权重</translation>
    </message>
    <message>
        <source>&amp;Invite raters…</source>
        <translation>邀请评分者(&amp;I)…</translation>
    </message>
    <message>
        <source>No rater has been invited yet. Press Invite raters: each gets the cases in an order of their own.</source>
        <translation>尚未邀请评分者。请按“邀请评分者”：每人的案例顺序各不相同。</translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s) changed hands. Reassign takes them back, too.</source>
        <translation>
            <numerusform>已转交 %n 份评分表。可用“改派”退回。</numerusform>
        </translation>
    </message>
    <message>
        <source>The adjudicators find the cases in their queues</source>
        <translation>仲裁评分者会在各自的队列中看到案例</translation>
    </message>
    <message>
        <source>The sheets of the chosen rows, or of all: to another rater, or back</source>
        <translation>所选行或全部行的评分表：改派给其他评分者，或退回</translation>
    </message>
    <message>
        <source>Sen&amp;d reminders…</source>
        <translation>发送提醒(&amp;D)…</translation>
    </message>
    <message>
        <source>By the mail server of the centre, to all who owe a sheet or some of them</source>
        <translation>通过中心的邮件服务器，发给全部或部分欠交者</translation>
    </message>
</context>
<context>
    <name>torsio::gui::SeverityPage</name>
    <message>
        <source>points from the panel: you judge as the others do.</source>
        <translation>分，与专家组之差：您与他人判断一致。</translation>
    </message>
    <message>
        <source>points from the panel: you are stricter.</source>
        <translation>分，与专家组之差：您较严格。</translation>
    </message>
    <message>
        <source>points from the panel: you are milder.</source>
        <translation>分，与专家组之差：您较宽松。</translation>
    </message>
    <message>
        <source>95 % interval %1 to %2; cases: %3. Your mean is %4, the others&apos; %5.</source>
        <translation>95 % 区间 %1 至 %2；案例数：%3。您的均分 %4，他人 %5。</translation>
    </message>
    <message>
        <source>From one case; an interval needs two at least.</source>
        <translation>仅有一个案例；区间至少需要两个。</translation>
    </message>
    <message>
        <source>Nothing to compare yet.</source>
        <translation>暂无可比较的内容。</translation>
    </message>
    <message>
        <source>Cases appear here once all physicians have submitted them.</source>
        <translation>所有医师提交后，案例会显示在这里。</translation>
    </message>
    <message>
        <source>Your cases that wait for the others: %1. Thank you for your time.</source>
        <translation>等待他人提交的案例：%1。感谢您付出的时间。</translation>
    </message>
    <message>
        <source>Thank you for your time. Reports never correct your marks silently.</source>
        <translation>感谢您付出的时间。报告绝不会悄悄修正您的评分。</translation>
    </message>
    <message>
        <source>Case %1</source>
        <translation>案例 %1</translation>
    </message>
    <message>
        <source>My severity</source>
        <translation>我的严格度</translation>
    </message>
    <message>
        <source>For your eyes only. Overall marks of cases that all have submitted; the mean of the others does not contain yours.</source>
        <translation>仅供您本人查看。取所有人均已提交案例的总评；他人均分不含您的评分。</translation>
    </message>
    <message>
        <source>You and the panel</source>
        <translation>您与专家组</translation>
    </message>
    <message>
        <source>Your mark (upwards) against the panel&apos;s mean</source>
        <translation>您的评分（纵轴）与专家组均分</translation>
    </message>
    <message>
        <source>Your marks and the panel&apos;s, case by case</source>
        <translation>逐案例的您与专家组评分</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>案例</translation>
    </message>
    <message>
        <source>You</source>
        <translation>自评</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>专家组</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差值</translation>
    </message>
    <message>
        <source>No case is complete yet.</source>
        <translation>尚无完成的案例。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::SeverityPlot</name>
    <message>
        <source>Your marks against the panel&apos;s</source>
        <translation>您的评分与专家组对照</translation>
    </message>
    <message>
        <source>Cases: %1; the list beside it holds the same figures</source>
        <translation>案例数：%1；旁边的列表含有相同数据</translation>
    </message>
    <message>
        <source>mean of the others, points</source>
        <translation>他人均分</translation>
    </message>
    <message>
        <source>you are milder</source>
        <translation>您较宽松</translation>
    </message>
    <message>
        <source>you are stricter</source>
        <translation>您较严格</translation>
    </message>
</context>
<context>
    <name>torsio::gui::SheetEditorPanel</name>
    <message>
        <source>Not saved</source>
        <translation>未保存</translation>
    </message>
</context>
<context>
    <name>torsio::gui::SheetPanel</name>
    <message>
        <source>Co&amp;mment for the trainee</source>
        <translation>给学员的评论(&amp;M)</translation>
    </message>
    <message>
        <source>What would help most next time?</source>
        <translation>下次怎样做最有帮助？</translation>
    </message>
    <message>
        <source>Overall</source>
        <translation>总分</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ShellContext</name>
    <message>
        <source>Something unexpected happened</source>
        <translation>发生意外情况</translation>
    </message>
    <message>
        <source>Nothing was lost; please try again</source>
        <translation>内容没有丢失，请重试</translation>
    </message>
    <message>
        <source>Cancelled; nothing was changed</source>
        <translation>已取消，没有任何更改</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ShortcutSheet</name>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>通用</translation>
    </message>
    <message>
        <source>This list</source>
        <translation>本页</translation>
    </message>
    <message>
        <source>F1, or ?</source>
        <translation>F1 或 ?</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>全屏</translation>
    </message>
    <message>
        <source>Next field, previous field</source>
        <translation>下一字段、上一字段</translation>
    </message>
    <message>
        <source>Tab, Shift + Tab</source>
        <translation>Tab、Shift + Tab</translation>
    </message>
    <message>
        <source>Page of the navigation</source>
        <translation>导航中的页面</translation>
    </message>
    <message>
        <source>Alt + 1 to Alt + 9</source>
        <translation>Alt + 1 至 Alt + 9</translation>
    </message>
    <message>
        <source>Lock now</source>
        <translation>立即锁定</translation>
    </message>
    <message>
        <source>Close a dialog, let go</source>
        <translation>关闭对话框、松开</translation>
    </message>
    <message>
        <source>On this page</source>
        <translation>本页面</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ShownOnceDialog</name>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>已复制</translation>
    </message>
    <message>
        <source>Cards saved</source>
        <translation>卡片已保存</translation>
    </message>
    <message>
        <source>Save cards</source>
        <translation>保存卡片</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Nothing was copied or saved, and this is not shown again. Close all the same?</source>
        <translation>尚未复制或保存，且此内容不再显示。仍要关闭吗？</translation>
    </message>
    <message>
        <source>Save c&amp;ards (PDF)…</source>
        <translation>保存卡片 (PDF)(&amp;A)…</translation>
    </message>
</context>
<context>
    <name>torsio::gui::SignInPanel</name>
    <message>
        <source>You may try again now</source>
        <translation>现在可以重试</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>正在检查…</translation>
    </message>
    <message>
        <source>Practice with your PIN</source>
        <translation>使用 PIN 码练习</translation>
    </message>
    <message>
        <source>Sign in</source>
        <translation>登录</translation>
    </message>
    <message>
        <source>Sign-in &amp;name</source>
        <translation>登录名(&amp;N)</translation>
    </message>
    <message>
        <source>Station &amp;PIN</source>
        <translation>工作站 PIN 码(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Password</source>
        <translation>密码(&amp;P)</translation>
    </message>
    <message>
        <source>Practise</source>
        <translation>开始练习</translation>
    </message>
    <message>
        <source>Sign in with the password</source>
        <translation>使用密码登录</translation>
    </message>
    <message>
        <source>Practise with a PIN</source>
        <translation>使用 PIN 码练习</translation>
    </message>
    <message>
        <source>Practise as a guest</source>
        <translation>以访客身份练习</translation>
    </message>
    <message>
        <source>With a PIN or as a guest nothing is recorded and nothing is scored.</source>
        <translation>使用 PIN 码或访客身份时，不记录也不评分。</translation>
    </message>
    <message>
        <source>Leave kiosk mode…</source>
        <translation>退出自助终端模式…</translation>
    </message>
    <message>
        <source>A training tool and not a medical device. No patient data.</source>
        <translation>培训工具，不是医疗器械。不含患者数据。</translation>
    </message>
    <message>
        <source>Hold your &amp;card to the scanner, or type its code</source>
        <translation>请将卡片对准扫码器，或输入其代码(&amp;C)</translation>
    </message>
    <message>
        <source>Too many wrong tries. Please wait %1</source>
        <translation>错误次数过多，请等待 %1</translation>
    </message>
</context>
<context>
    <name>torsio::gui::SimulationController</name>
    <message>
        <source>Something unexpected went wrong</source>
        <translation>出现意外错误</translation>
    </message>
    <message>
        <source>Please report this.</source>
        <translation>请报告此问题。</translation>
    </message>
    <message>
        <source>Stop the recording before choosing another exercise.</source>
        <translation>请先停止录制，再选择其他练习。</translation>
    </message>
    <message>
        <source>The simulation is busy; please try again.</source>
        <translation>模拟正忙，请重试。</translation>
    </message>
    <message>
        <source>There is no place to keep a recording.</source>
        <translation>没有可保存录制的位置。</translation>
    </message>
    <message>
        <source>The recording could not go to its usual place and was kept as a file</source>
        <translation>记录无法保存到通常位置，已存为文件</translation>
    </message>
    <message>
        <source>Free some space or check the database, then import the file.</source>
        <translation>请释放空间或检查数据库，然后导入该文件。</translation>
    </message>
    <message>
        <source>Stop the recording before replaying another one.</source>
        <translation>请先停止录制，再回放其他内容。</translation>
    </message>
    <message>
        <source>No haptic device was found. You practise with mouse and keyboard</source>
        <translation>未找到力反馈设备。您将使用鼠标和键盘练习</translation>
    </message>
    <message>
        <source>You practise with mouse and keyboard: %1</source>
        <translation>您将使用鼠标和键盘练习：%1</translation>
    </message>
    <message>
        <source>You practise with %1. The force is felt</source>
        <translation>您正在使用 %1 练习，可以感受到力</translation>
    </message>
    <message>
        <source>The haptic device was lost. The recording until then is kept; you go on with the mouse</source>
        <translation>力反馈设备已断开。此前的记录已保留；您可用鼠标继续</translation>
    </message>
    <message>
        <source>You practise with %1. The force is shown, not felt</source>
        <translation>您正在使用 %1 练习。力只显示，感觉不到</translation>
    </message>
    <message>
        <source>The haptic device was lost. Let go of it; you go on with the mouse</source>
        <translation>力反馈设备已断开。请松开它；您将继续使用鼠标</translation>
    </message>
    <message>
        <source>Recorded: %1. Replay shows it again</source>
        <translation>已录制：%1。可用“回放”重新观看</translation>
    </message>
    <message>
        <source>This organ was accepted with a warning, which stays with every recording: %1</source>
        <translation>该器官是带警告接受的，警告将随每次记录保存：%1</translation>
    </message>
</context>
<context>
    <name>torsio::gui::SimulatorWindow</name>
    <message>
        <source>Loading…</source>
        <translation>正在加载…</translation>
    </message>
    <message>
        <source>Hint</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Source of the organ</source>
        <translation>器官来源</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Mouse and keyboard</source>
        <translation>鼠标和键盘</translation>
    </message>
    <message>
        <source>Bring the jaw to the marked band</source>
        <translation>将钳口移到标记的环带处</translation>
    </message>
    <message>
        <source>Touching. Hold the first button of the stylus to grip</source>
        <translation>已接触。按住手写笔的第一个按钮以夹持</translation>
    </message>
    <message>
        <source>Holding. Lead the stylus round to twist; let the button go to release</source>
        <translation>已夹持。引导手写笔绕行以扭转；松开按钮即释放</translation>
    </message>
    <message>
        <source>The tissue returns to rest</source>
        <translation>组织正在恢复</translation>
    </message>
    <message>
        <source>%1 mm to the surface. Wheel: nearer</source>
        <translation>距表面 %1 mm。滚轮：靠近</translation>
    </message>
    <message>
        <source>Bring the jaw to the marked band. Wheel: depth, right drag: turn the view</source>
        <translation>将钳口移到标记带。滚轮：深度；右键拖动：转动视图</translation>
    </message>
    <message>
        <source>Touching. Hold the left button or Space to grip</source>
        <translation>已接触。按住左键或空格键夹持</translation>
    </message>
    <message>
        <source>Holding. Drag, or press Q and E, to twist; let go to release</source>
        <translation>已夹持。拖动或按 Q、E 键扭转；松开即释放</translation>
    </message>
    <message>
        <source>%1 – Torsio</source>
        <translation>%1 – Torsio</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>录制</translation>
    </message>
    <message>
        <source>Open organ</source>
        <translation>打开器官</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>毫米</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>厘米</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>米</translation>
    </message>
    <message>
        <source>The file&apos;s numbers are</source>
        <translation>文件中的数值单位为</translation>
    </message>
    <message>
        <source>Nothing has been recorded yet.</source>
        <translation>尚无录制内容。</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Torsio</source>
        <translation>Torsio</translation>
    </message>
    <message>
        <source>Move the instrument</source>
        <translation>移动器械</translation>
    </message>
    <message>
        <source>Mouse, or arrow keys</source>
        <translation>鼠标或方向键</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>Wheel, or Page Up and Page Down</source>
        <translation>滚轮，或 Page Up、Page Down 键</translation>
    </message>
    <message>
        <source>Grip</source>
        <translation>夹持</translation>
    </message>
    <message>
        <source>Left button or Space (hold), G (keep)</source>
        <translation>左键或空格键（按住），G 键（保持）</translation>
    </message>
    <message>
        <source>Twist what is held</source>
        <translation>扭转所夹组织</translation>
    </message>
    <message>
        <source>Drag, Shift + wheel, or Q and E</source>
        <translation>拖动、Shift + 滚轮，或 Q、E 键</translation>
    </message>
    <message>
        <source>Tilt the instrument</source>
        <translation>倾斜器械</translation>
    </message>
    <message>
        <source>A, D, W, S</source>
        <translation>A、D、W、S</translation>
    </message>
    <message>
        <source>Let go</source>
        <translation>松开</translation>
    </message>
    <message>
        <source>Release the button, or Esc</source>
        <translation>松开按键，或按 Esc</translation>
    </message>
    <message>
        <source>Bookmark</source>
        <translation>书签</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>转动视图</translation>
    </message>
    <message>
        <source>Right drag, or Ctrl + arrow keys</source>
        <translation>右键拖动，或 Ctrl + 方向键</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>平移视图</translation>
    </message>
    <message>
        <source>Middle drag</source>
        <translation>中键拖动</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Ctrl + wheel, or + and −</source>
        <translation>Ctrl + 滚轮，或 + 和 −</translation>
    </message>
    <message>
        <source>Controls</source>
        <translation>操作方法</translation>
    </message>
    <message>
        <source>About Torsio</source>
        <translation>关于 Torsio</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Torsio %1&lt;/h3&gt;&lt;p&gt;Training and assessment of surgical twist skills.&lt;/p&gt;&lt;p&gt;A training tool; not a medical device.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Torsio %1&lt;/h3&gt;&lt;p&gt;外科扭转技能的培训与评估。&lt;/p&gt;&lt;p&gt;培训工具，不是医疗器械。&lt;/p&gt;&lt;p&gt;自由软件，采用 GNU 通用公共许可证第 3 版或更高版本。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Open organ…</source>
        <translation>打开器官…</translation>
    </message>
    <message>
        <source>Use a mesh of your own instead of a shipped organ</source>
        <translation>使用自己的网格代替自带器官</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>图片…</translation>
    </message>
    <message>
        <source>Save the scene as a PNG picture</source>
        <translation>将场景保存为 PNG 图片</translation>
    </message>
    <message>
        <source>Film strip…</source>
        <translation>连续画面…</translation>
    </message>
    <message>
        <source>Save the twist at 0, 30, 60 … degrees, or the recording that is replayed, as one picture</source>
        <translation>把 0、30、60……度时的扭转，或正在回放的记录，保存为一张图片</translation>
    </message>
    <message>
        <source>Start the exercise anew and record it</source>
        <translation>重新开始练习并录制</translation>
    </message>
    <message>
        <source>Replay…</source>
        <translation>回放…</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>释放</translation>
    </message>
    <message>
        <source>Let go of the tissue; it returns to rest</source>
        <translation>松开组织，使其恢复</translation>
    </message>
    <message>
        <source>Restart exercise</source>
        <translation>重新开始练习</translation>
    </message>
    <message>
        <source>Begin the exercise anew</source>
        <translation>从头开始练习</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>从正面观察</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>侧面</translation>
    </message>
    <message>
        <source>Look from the patient&apos;s left side</source>
        <translation>从患者左侧观察</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上方</translation>
    </message>
    <message>
        <source>Look from the head</source>
        <translation>从头侧观察</translation>
    </message>
    <message>
        <source>Whole organ</source>
        <translation>整个器官</translation>
    </message>
    <message>
        <source>Show the whole organ</source>
        <translation>显示整个器官</translation>
    </message>
    <message>
        <source>Lattice</source>
        <translation>网格线</translation>
    </message>
    <message>
        <source>Show ridges and sections on the tissue</source>
        <translation>在组织上显示脊线和截面</translation>
    </message>
    <message>
        <source>Wireframe</source>
        <translation>线框</translation>
    </message>
    <message>
        <source>Show the edges of the surface</source>
        <translation>显示表面的边</translation>
    </message>
    <message>
        <source>Shear stress</source>
        <translation>剪应力</translation>
    </message>
    <message>
        <source>Colour the tissue by its shear stress</source>
        <translation>按剪应力为组织着色</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记点</translation>
    </message>
    <message>
        <source>Show the marker points of the organ</source>
        <translation>显示器官的标记点</translation>
    </message>
    <message>
        <source>Target pose</source>
        <translation>目标姿态</translation>
    </message>
    <message>
        <source>Show the pose to reach as a film over the organ</source>
        <translation>以半透明形式显示需要达到的姿态</translation>
    </message>
    <message>
        <source>Keys…</source>
        <translation>按键…</translation>
    </message>
    <message>
        <source>Put the movements of the instrument on other keys</source>
        <translation>将器械动作改到其他按键</translation>
    </message>
    <message>
        <source>How mouse and keys move the instrument</source>
        <translation>如何用鼠标和键盘移动器械</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>As fine as this machine draws smoothly</source>
        <translation>在本机流畅的前提下尽量精细</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>快速</translation>
    </message>
    <message>
        <source>Fewer effects, more pictures a second</source>
        <translation>效果较少，帧率更高</translation>
    </message>
    <message>
        <source>Fine</source>
        <translation>精细</translation>
    </message>
    <message>
        <source>Shadow, ambient occlusion and antialiasing</source>
        <translation>阴影、环境光遮蔽和抗锯齿</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>画质</translation>
    </message>
    <message>
        <source>More</source>
        <translation>更多</translation>
    </message>
    <message>
        <source>More commands</source>
        <translation>更多命令</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Dark colours for a dark room</source>
        <translation>适合暗室的深色</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>全屏</translation>
    </message>
    <message>
        <source>Fill the whole screen</source>
        <translation>铺满整个屏幕</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>退出</translation>
    </message>
    <message>
        <source>End the program</source>
        <translation>结束程序</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>版本与许可证</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Exercise</source>
        <translation>练习(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>torsio.png</source>
        <translation>torsio.png</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG 图片 (*.png)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>There is no picture to capture here</source>
        <translation>此处没有可截取的画面</translation>
    </message>
    <message>
        <source>Stop the recording before you save a film strip.</source>
        <translation>请先停止记录，再保存连续画面。</translation>
    </message>
    <message>
        <source>Save film strip</source>
        <translation>保存连续画面</translation>
    </message>
    <message>
        <source>film-strip.png</source>
        <translation>film-strip.png</translation>
    </message>
    <message>
        <source>Compare models</source>
        <translation>模型对比</translation>
    </message>
    <message>
        <source>Twist this organ by the twist model, finite elements and springs under one torque</source>
        <translation>在同一扭矩下用扭转模型、有限元和弹簧扭转该器官</translation>
    </message>
    <message>
        <source>Touching. Close the jaw to grip</source>
        <translation>已接触。闭合钳口以夹持</translation>
    </message>
    <message>
        <source>Holding. Turn the jaw to twist; open it to release</source>
        <translation>已夹持。转动钳口以扭转；张开即释放</translation>
    </message>
    <message>
        <source>Replay of a recorded run</source>
        <translation>正在回放已录制的操作</translation>
    </message>
    <message>
        <source>● Recording  %1</source>
        <translation>● 正在录制  %1</translation>
    </message>
    <message>
        <source>Look at a recorded run again</source>
        <translation>重新观看已录制的操作</translation>
    </message>
    <message>
        <source>Recorded run</source>
        <translation>已录制的操作</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>最佳</translation>
    </message>
    <message>
        <source>The finest shadow and edges; needs a graphics card</source>
        <translation>最细腻的阴影和边缘；需要显卡</translation>
    </message>
    <message>
        <source>%1   %2, %3   %4</source>
        <translation>%1   %2，%3   %4</translation>
    </message>
    <message>
        <source>%1 after %2</source>
        <translation>%2 后：%1</translation>
    </message>
    <message>
        <source>Organs and meshes (*.organ *.obj *.stl *.ply *.off *.glb *.gltf *.dae);;All files (*)</source>
        <translation>器官和网格 (*.organ *.obj *.stl *.ply *.off *.glb *.gltf *.dae);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Bring an organ…</source>
        <translation>导入器官…</translation>
    </message>
    <message>
        <source>Make an organ of a mesh or a scan of your own: look at it, judge it, keep it</source>
        <translation>用您自己的网格或扫描制作器官：查看、评判、保存</translation>
    </message>
</context>
<context>
    <name>torsio::gui::SliceView</name>
    <message>
        <source>front</source>
        <translation>前</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>back</source>
        <translation>后</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>head</source>
        <translation>头</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>足</translation>
    </message>
</context>
<context>
    <name>torsio::gui::StandardDialog</name>
    <message>
        <source>Pass from %1 of %2 items on (%3 %).</source>
        <translation>达到 %1 项（共 %2 项，%3 %）即通过。</translation>
    </message>
    <message>
        <source>%1 judges; they differ by %2 items (standard deviation), the cut is sure to %3 (standard error).</source>
        <translation>%1 位评判者；彼此相差 %2 项（标准差），界线准确到 %3（标准误）。</translation>
    </message>
    <message>
        <source>One judge alone says nothing about how sure this is.</source>
        <translation>只有一位评判者，无法说明其可靠程度。</translation>
    </message>
    <message>
        <source>Pass from a score of %1 on (standard error %2). The ratings of %3 subjects explain %4 % of the scores.</source>
        <translation>得分达到 %1 即通过（标准误 %2）。%3 名受试者的总体评级解释了得分变异的 %4 %。</translation>
    </message>
    <message>
        <source>Pass from a score of %1 on: %2 % of %3 novices would pass wrongly, %4 % of %5 masters fail wrongly, were their scores normal.</source>
        <translation>得分达到 %1 即通过：若得分呈正态分布，%3 名新手中有 %2 % 会误通过，%5 名熟练者中有 %4 % 会误不通过。</translation>
    </message>
    <message>
        <source>Where to draw the line</source>
        <translation>及格线划在哪里</translation>
    </message>
    <message>
        <source>judges say who would succeed (Angoff)</source>
        <translation>评判者估计谁会成功（Angoff）</translation>
    </message>
    <message>
        <source>global ratings beside scores (borderline regression)</source>
        <translation>总体评级与得分对照（边缘回归）</translation>
    </message>
    <message>
        <source>novices and masters (contrasting groups)</source>
        <translation>新手与熟练者（对照组法）</translation>
    </message>
    <message>
        <source>&amp;Method</source>
        <translation>方法(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Table</source>
        <translation>表格(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Rating that means borderline</source>
        <translation>表示处于边缘的评级(&amp;R)</translation>
    </message>
    <message>
        <source>The line</source>
        <translation>界线</translation>
    </message>
    <message>
        <source>One line for each judge and item: of a hundred borderline trainees, how many would succeed in it.</source>
        <translation>每位评判者对每个项目一行：一百名处于及格边缘的学员中，有多少人会成功。</translation>
    </message>
    <message>
        <source>One line for each subject: the score, and an expert&apos;s rating of the whole performance.</source>
        <translation>每位受试者一行：得分，以及专家对整体表现的评级。</translation>
    </message>
    <message>
        <source>One line for each subject: novice or master, as others have judged, and the score; higher is better.</source>
        <translation>每位受试者一行：由他人判定的新手或熟练者，以及得分；越高越好。</translation>
    </message>
    <message>
        <source>judge,item,percent
J1,grip,80
J2,grip,70</source>
        <translation>judge,item,percent
J1,grip,80
J2,grip,70</translation>
    </message>
    <message>
        <source>subject,global,score
T-01,3,14.5
T-02,4,17</source>
        <translation>subject,global,score
T-01,3,14.5
T-02,4,17</translation>
    </message>
    <message>
        <source>subject,group,score
T-01,novice,11
T-02,master,17</source>
        <translation>subject,group,score
T-01,novice,11
T-02,master,17</translation>
    </message>
    <message>
        <source>Paste the table above, with its first line as in the example.</source>
        <translation>请把表格粘贴到上方，第一行与示例相同。</translation>
    </message>
    <message>
        <source>table</source>
        <translation>表格</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>torsio::gui::StationSettingsCard</name>
    <message>
        <source>Kept. It holds at every station from the next sign-in on</source>
        <translation>已保存。从下次登录起在所有工作站生效</translation>
    </message>
    <message>
        <source>At every station</source>
        <translation>所有工作站</translation>
    </message>
    <message>
        <source>When nobody is there, &amp;warn after</source>
        <translation>无人操作时，提醒时间(&amp;W)</translation>
    </message>
    <message>
        <source>and &amp;lock after</source>
        <translation>锁定时间(&amp;L)</translation>
    </message>
    <message>
        <source> min</source>
        <translation> 分钟</translation>
    </message>
    <message>
        <source>&amp;Grade runs with mouse and keyboard</source>
        <translation>鼠标和键盘的操作也计分(&amp;G)</translation>
    </message>
    <message>
        <source>A run is never interrupted by this. A kiosk signs out instead of locking.</source>
        <translation>操作绝不会因此中断。自助终端模式下会注销而不是锁定。</translation>
    </message>
    <message>
        <source>&amp;Name of the centre</source>
        <translation>中心名称(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Two people for new passwords and roles of those who score or run the study, for erasing, restoring and opening the allocation</source>
        <translation>评分者和研究管理者的新密码与角色，以及删除、恢复和启封分组，须两人共同完成(&amp;T)</translation>
    </message>
    <message>
        <source>one signature</source>
        <translation>一次签名</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>A password that was &amp;entered signs for</source>
        <translation>输入一次密码可签名(&amp;E)</translation>
    </message>
    <message>
        <source>A sound when a l&amp;imit is reached (not in a room that is shared)</source>
        <translation>达到限值时发出提示音（不宜用于共用的房间）(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Kiosks let trainees in by the code on their card, without a password (from their next start on)</source>
        <translation>自助终端允许学员凭卡片代码登录，无需密码（下次启动起生效）(&amp;K)</translation>
    </message>
    <message>
        <source>Learning &amp;records…</source>
        <translation>学习记录(&amp;R)…</translation>
    </message>
    <message>
        <source>Enter the name of your centre.</source>
        <translation>请输入贵中心的名称。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::StressLegend</name>
    <message>
        <source>%1 kPa</source>
        <translation>%1 kPa</translation>
    </message>
    <message>
        <source>%1 Pa</source>
        <translation>%1 Pa</translation>
    </message>
    <message>
        <source>Shear stress</source>
        <translation>剪应力</translation>
    </message>
    <message>
        <source>Dark blue is %1, yellow is %2 and more</source>
        <translation>深蓝为 %1，黄色为 %2 及以上</translation>
    </message>
</context>
<context>
    <name>torsio::gui::TraceDialog</name>
    <message>
        <source>Where a number comes from</source>
        <translation>数值的来源</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>组成</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>What the chosen number was made of</source>
        <translation>所选数值的组成</translation>
    </message>
    <message>
        <source>Choose a number; type a code such as T-07 to find those of a person. Below stands what it was made of: open a step to go on to marks, criteria, scoring sheet, recording and program.</source>
        <translation>请选择一个数值；输入 T-07 之类的代码可查找某人的数值。下方列出其组成：展开各步可追溯到评分、评分项、评分标准、录制和程序。</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>数值名称</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>组</translation>
    </message>
    <message>
        <source>Model or criterion</source>
        <translation>模型或评分项</translation>
    </message>
    <message>
        <source>Index or rater</source>
        <translation>指标或评分者</translation>
    </message>
    <message>
        <source>Occasion</source>
        <translation>评分时点</translation>
    </message>
    <message>
        <source>Following the number</source>
        <translation>正在追溯数值</translation>
    </message>
</context>
<context>
    <name>torsio::gui::TraceView</name>
    <message>
        <source>Traces of angle, torque and force</source>
        <translation>角度、扭矩和力的曲线</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>扭矩</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Nothing is loaded</source>
        <translation>未载入任何内容</translation>
    </message>
    <message>
        <source>%1 long; greatest angle %2 degrees, torque %3 newton metres, force %4 newtons; bookmarks: %5</source>
        <translation>时长 %1；最大角度 %2 度，扭矩 %3 牛·米，力 %4 牛；书签：%5</translation>
    </message>
    <message>
        <source>Blood flow</source>
        <translation>血流</translation>
    </message>
    <message>
        <source>Ischaemic dose</source>
        <translation>缺血剂量</translation>
    </message>
    <message>
        <source>Black share</source>
        <translation>变黑比例</translation>
    </message>
    <message>
        <source>Lumen</source>
        <translation>管腔</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>压力</translation>
    </message>
    <message>
        <source>Dashed: from an ischaemic dose of 1 on the tissue is lost. The black share tells how much of the outside has turned black from loss</source>
        <translation>虚线：缺血剂量达到 1 则组织坏死。变黑比例表示外表面因坏死而变黑的部分</translation>
    </message>
    <message>
        <source>Traces of an untwisting</source>
        <translation>复位过程的曲线</translation>
    </message>
    <message>
        <source>%1 long; scales: %2; bookmarks: %3</source>
        <translation>时长 %1；刻度：%2；书签：%3</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>Shaded: within the tolerance of the target.</source>
        <translation>阴影：目标的容差范围。</translation>
    </message>
    <message>
        <source>Dashed across torque and force: the limit of the exercise.</source>
        <translation>扭矩和力曲线上的虚线：练习的限值。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::TrackerPanel</name>
    <message>
        <source>&amp;Disconnect</source>
        <translation>断开(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Connect</source>
        <translation>连接(&amp;C)</translation>
    </message>
    <message>
        <source>No tracker: where the instrument is, is not recorded.</source>
        <translation>没有跟踪器：不记录器械的位置。</translation>
    </message>
    <message>
        <source>Waiting for the tracker to call.</source>
        <translation>正在等待跟踪器连接。</translation>
    </message>
    <message>
        <source>Calling the tracker.</source>
        <translation>正在连接跟踪器。</translation>
    </message>
    <message>
        <source>Connected. No pose of the instrument has come yet.</source>
        <translation>已连接，尚未收到器械的位姿。</translation>
    </message>
    <message>
        <source>The instrument is seen, and recorded.</source>
        <translation>能看到器械，正在记录。</translation>
    </message>
    <message>
        <source>The instrument is seen.</source>
        <translation>能看到器械。</translation>
    </message>
    <message>
        <source>The instrument is not seen. Turn it towards the tracker.</source>
        <translation>看不到器械。请将其转向跟踪器。</translation>
    </message>
    <message>
        <source>%1 Last trouble: %2.</source>
        <comment>a sentence, and what the tracker or the network said</comment>
        <translation>%1最近的问题：%2。</translation>
    </message>
    <message>
        <source>%1: %2, %3, %4 mm, turned by %5°</source>
        <translation>%1：%2、%3、%4 mm，转动 %5°</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Poses: %1, missing: %2, late: %3, of no use: %4; %5 a second</source>
        <translation>位姿：%1，缺失：%2，迟到：%3，无效：%4；每秒 %5 个</translation>
    </message>
    <message>
        <source>Tracker on the instrument</source>
        <translation>器械上的跟踪器</translation>
    </message>
    <message>
        <source>&amp;Address</source>
        <translation>地址(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>端口(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Instrument</source>
        <translation>器械(&amp;I)</translation>
    </message>
    <message>
        <source>the first that comes</source>
        <translation>最先出现的器械</translation>
    </message>
    <message>
        <source>&amp;Wait for the tracker to call</source>
        <translation>等待跟踪器来连接(&amp;W)</translation>
    </message>
</context>
<context>
    <name>torsio::gui::TranscriptPage</name>
    <message>
        <source>Every module and attempt</source>
        <translation>所有模块和尝试</translation>
    </message>
    <message>
        <source>Save it as PDF or print it, and take it with you.</source>
        <translation>可保存为 PDF 或打印带走。</translation>
    </message>
    <message>
        <source>Save as &amp;PDF…</source>
        <translation>保存为 PDF(&amp;P)…</translation>
    </message>
    <message>
        <source>P&amp;rint…</source>
        <translation>打印(&amp;R)…</translation>
    </message>
    <message>
        <source>Transcript of twist training</source>
        <translation>扭转训练成绩单</translation>
    </message>
    <message>
        <source>Demonstration: these people and runs are simulated.</source>
        <translation>演示数据：人员和操作均为模拟。</translation>
    </message>
    <message>
        <source>Trainee %1</source>
        <translation>学员 %1</translation>
    </message>
    <message>
        <source>%1 (trainee %2)</source>
        <translation>%1（学员 %2）</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Programme: %1</source>
        <translation>方案：%1</translation>
    </message>
    <message>
        <source>Time trained: %1 min on the simulator, %2 min on the real arm, %3 min of rest.</source>
        <translation>训练时间：模拟器 %1 分钟，实物手臂 %2 分钟，休息 %3 分钟。</translation>
    </message>
    <message>
        <source>%1. Level: %2.</source>
        <translation>%1。水平：%2。</translation>
    </message>
    <message>
        <source>When</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Twists on target</source>
        <translation>达标扭转</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Graded</source>
        <translation>计分</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>练习</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>已中断</translation>
    </message>
    <message>
        <source>running</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>Made on %1 with Torsio %2. A training record, no certificate of clinical competence.</source>
        <translation>由 Torsio %2 于 %1 生成。本记录为训练记录，不是临床能力证明。</translation>
    </message>
    <message>
        <source>Signature: ______________________________</source>
        <translation>签名：______________________________</translation>
    </message>
    <message>
        <source>transcript-%1.pdf</source>
        <translation>成绩单-%1.pdf</translation>
    </message>
    <message>
        <source>Save transcript</source>
        <translation>保存成绩单</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Saved to %1</source>
        <translation>已保存到 %1</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>force cut by the machine, times: %1</source>
        <translation>因计算机繁忙力中断 %1 次</translation>
    </message>
</context>
<context>
    <name>torsio::gui::TrendPage</name>
    <message>
        <source>Your way</source>
        <translation>您的进程</translation>
    </message>
    <message>
        <source>Every attempt is kept and shown.</source>
        <translation>每次尝试都会保存并显示。</translation>
    </message>
    <message>
        <source>&amp;Module</source>
        <translation>模块(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Quantity</source>
        <translation>指标(&amp;Q)</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>Distance to the threshold</source>
        <translation>与阈值的差距</translation>
    </message>
    <message>
        <source>missing in the last run; threshold %1</source>
        <translation>上次操作的差距；阈值 %1</translation>
    </message>
    <message>
        <source>Reached</source>
        <translation>已达到</translation>
    </message>
    <message>
        <source>in the last run; threshold %1</source>
        <translation>上次操作；阈值 %1</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>This quantity has no threshold in this module.</source>
        <translation>本模块对该指标没有阈值。</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>尝试次数</translation>
    </message>
    <message>
        <source>Graded attempts left: %1</source>
        <translation>剩余计分尝试：%1</translation>
    </message>
    <message>
        <source>No limit in this module.</source>
        <translation>本模块不限次数。</translation>
    </message>
    <message>
        <source>Attempts over time</source>
        <translation>历次尝试</translation>
    </message>
    <message>
        <source>Filled circle: passed. Triangle: not passed.</source>
        <translation>实心圆：通过。三角：未通过。</translation>
    </message>
    <message>
        <source>%1 A learning curve is drawn from eight attempts on.</source>
        <translation>%1满八次后绘制学习曲线。</translation>
    </message>
    <message>
        <source>%1 No learning curve fits these values.</source>
        <translation>%1 没有学习曲线能拟合这些数值。</translation>
    </message>
    <message>
        <source>%1 Line and band: learning curve with its 95 % band.</source>
        <translation>%1曲线与色带：学习曲线及其 95% 区间。</translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>次序</translation>
    </message>
    <message>
        <source>When</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>No attempt yet. Your runs at this module appear here.</source>
        <translation>尚无尝试。您在本模块的操作会显示在这里。</translation>
    </message>
    <message>
        <source>Graded</source>
        <translation>计分</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>练习</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>通过</translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation>未通过</translation>
    </message>
    <message>
        <source>Not reached</source>
        <translation>未达到</translation>
    </message>
    <message>
        <source>in the last run; wanted: %1</source>
        <translation>上次操作；要求：%1</translation>
    </message>
    <message>
        <source>%1 A yes or no has no learning curve.</source>
        <translation>%1 是或否的指标没有学习曲线。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::TrendPlot</name>
    <message>
        <source>%1 over the attempts</source>
        <translation>%1随尝试次数的变化</translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>次序</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>threshold</source>
        <translation>阈值</translation>
    </message>
</context>
<context>
    <name>torsio::gui::TroublePanel</name>
    <message>
        <source>The database cannot be used</source>
        <translation>数据库无法使用</translation>
    </message>
    <message>
        <source>Try again; if it stays so, ask your administrator</source>
        <translation>请重试；如仍无法解决，请联系管理员</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Use another database…</source>
        <translation>使用其他数据库…</translation>
    </message>
</context>
<context>
    <name>torsio::gui::TwistGuide</name>
    <message>
        <source>Your first twist</source>
        <translation>第一次扭转</translation>
    </message>
    <message>
        <source>Your first twist: movement %1 of %2</source>
        <translation>第一次扭转：第 %1 个动作，共 %2 个</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>跳过</translation>
    </message>
    <message>
        <source>It came loose. Bring the jaw to the band once more</source>
        <translation>组织滑脱了。请再次将钳口移到环带处</translation>
    </message>
    <message>
        <source>Bring the jaw to the marked band</source>
        <translation>将钳口移到标记的环带处</translation>
    </message>
    <message>
        <source>Move the stylus until the jaw touches the organ.</source>
        <translation>移动触笔，直到钳口接触器官。</translation>
    </message>
    <message>
        <source>Move the mouse; the wheel moves the instrument nearer, until it touches.</source>
        <translation>移动鼠标；滚轮使器械靠近，直到接触。</translation>
    </message>
    <message>
        <source>Close the jaw</source>
        <translation>夹紧钳口</translation>
    </message>
    <message>
        <source>Press the button of the stylus and keep it pressed.</source>
        <translation>按住触笔上的按钮不放。</translation>
    </message>
    <message>
        <source>Hold the left mouse button or Space, and keep it held.</source>
        <translation>按住鼠标左键或空格键不放。</translation>
    </message>
    <message>
        <source>Turn to the mark on the dial</source>
        <translation>转到表盘上的标记处</translation>
    </message>
    <message>
        <source>Carry the jaw round the organ in one even movement.</source>
        <translation>带着钳口绕器官平稳地转动一次。</translation>
    </message>
    <message>
        <source>Drag, or press Q or E, in one even movement.</source>
        <translation>拖动鼠标，或按 Q 或 E，平稳地转动一次。</translation>
    </message>
    <message>
        <source>Hold it there</source>
        <translation>在此保持</translation>
    </message>
    <message>
        <source>The ring round the dial fills while you hold.</source>
        <translation>保持期间，表盘外圈逐渐填满。</translation>
    </message>
    <message>
        <source>Open the jaw gently</source>
        <translation>轻轻张开钳口</translation>
    </message>
    <message>
        <source>Let go without a jerk; the organ turns back by itself.</source>
        <translation>松开时不要猛拉；器官自行回转。</translation>
    </message>
    <message>
        <source>That was a whole twist</source>
        <translation>一次完整的扭转完成了</translation>
    </message>
    <message>
        <source>Go on as you like; the debrief shows this run afterwards.</source>
        <translation>可以继续练习；之后训练复盘会显示本次操作。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::UsersPage</name>
    <message>
        <source>Users and roles</source>
        <translation>用户与角色</translation>
    </message>
    <message>
        <source>Who may sign in, and as what. Every change is kept in the audit trail.</source>
        <translation>谁可以登录以及担任何种角色。每次更改都记入审计记录。</translation>
    </message>
    <message>
        <source>&amp;New user…</source>
        <translation>新建用户(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Roles…</source>
        <translation>角色(&amp;R)…</translation>
    </message>
    <message>
        <source>New &amp;password…</source>
        <translation>新密码(&amp;P)…</translation>
    </message>
    <message>
        <source>Sign-in name</source>
        <translation>登录名</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>角色</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>密码</translation>
    </message>
    <message>
        <source>Station PIN</source>
        <translation>工作站 PIN 码</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>创建时间</translation>
    </message>
    <message>
        <source>No users yet.</source>
        <translation>尚无用户。</translation>
    </message>
    <message>
        <source>active</source>
        <translation>在册</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>已停用</translation>
    </message>
    <message>
        <source>to be changed</source>
        <translation>待修改</translation>
    </message>
    <message>
        <source>own</source>
        <translation>已自设</translation>
    </message>
    <message>
        <source>set</source>
        <translation>已设置</translation>
    </message>
    <message>
        <source>&amp;Enable</source>
        <translation>启用(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Disable…</source>
        <translation>停用(&amp;D)…</translation>
    </message>
    <message>
        <source>Sealing the start password</source>
        <translation>正在加密初始密码</translation>
    </message>
    <message>
        <source>New start password</source>
        <translation>新的初始密码</translation>
    </message>
    <message>
        <source>The present password of %1 stops working at once.</source>
        <translation>%1 的当前密码立即失效。</translation>
    </message>
    <message>
        <source>Disable user</source>
        <translation>停用用户</translation>
    </message>
    <message>
        <source>%1 cannot sign in any more; everything recorded stays.</source>
        <translation>%1 将无法登录，已记录的内容保留。</translation>
    </message>
    <message>
        <source>Enable user</source>
        <translation>启用用户</translation>
    </message>
    <message>
        <source>%1 can sign in again.</source>
        <translation>%1 可以重新登录。</translation>
    </message>
    <message>
        <source>&amp;Accounts for the roster…</source>
        <translation>为名册建立账户(&amp;A)…</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>人员</translation>
    </message>
    <message>
        <source>Everybody of the roster has an account</source>
        <translation>名册中的每个人都已有账户</translation>
    </message>
    <message>
        <source>Accounts for the roster</source>
        <translation>为名册建立账户</translation>
    </message>
    <message>
        <source>These people have no account yet. Each gets one: the code in small letters is the sign-in name, trainees train, raters score.</source>
        <translation>这些人还没有账户。每人将获得一个：登录名为小写的代码，学员用于训练，评分者用于评分。</translation>
    </message>
    <message>
        <source>Making accounts</source>
        <translation>正在建立账户</translation>
    </message>
    <message>
        <source>Cancelled; the accounts that were shown stay</source>
        <translation>已取消；已显示的账户仍然有效</translation>
    </message>
    <message>
        <source>Re&amp;quests…</source>
        <translation>申请(&amp;Q)…</translation>
    </message>
    <message>
        <source>Re&amp;quests (%1)…</source>
        <translation>申请 (%1)(&amp;Q)…</translation>
    </message>
    <message>
        <source>Another administrator confirms the roles under Requests</source>
        <translation>由另一位管理员在“申请”中确认角色</translation>
    </message>
    <message>
        <source>&amp;Kiosk cards…</source>
        <translation>自助终端卡片(&amp;K)…</translation>
    </message>
    <message>
        <source>Of the chosen trainees, or of all: a card with a barcode that opens a kiosk. A card made before is of no use then.</source>
        <translation>为所选学员或全部学员生成带条形码的自助终端登录卡片。此前的卡片随即失效。</translation>
    </message>
    <message>
        <source>Re&amp;voke cards…</source>
        <translation>撤销卡片(&amp;V)…</translation>
    </message>
    <message>
        <source>Kiosk card</source>
        <translation>自助终端卡片</translation>
    </message>
    <message>
        <source>Revoke cards</source>
        <translation>撤销卡片</translation>
    </message>
    <message>
        <source>The cards of the chosen users open no kiosk any more.</source>
        <translation>所选用户的卡片将不能再在自助终端登录。</translation>
    </message>
    <message>
        <source>Cards revoked: %1</source>
        <translation>已撤销卡片：%1</translation>
    </message>
    <message>
        <source>&amp;Invite…</source>
        <translation>邀请登录(&amp;I)…</translation>
    </message>
    <message>
        <source>A link for each of the chosen users, with which they set a password in a browser.</source>
        <translation>为每个所选用户生成一个链接，用于在浏览器中设置密码。</translation>
    </message>
    <message>
        <source>Invited until</source>
        <translation>邀请有效期</translation>
    </message>
    <message>
        <source>Revoke invitations</source>
        <translation>撤销登录邀请</translation>
    </message>
    <message>
        <source>The links of the chosen users are of no use any more.</source>
        <translation>所选用户的链接随即失效。</translation>
    </message>
    <message>
        <source>Invitations revoked: %1</source>
        <translation>已撤销登录邀请：%1</translation>
    </message>
    <message>
        <source>Revoke &amp;links…</source>
        <translation>撤销链接(&amp;L)…</translation>
    </message>
    <message>
        <source>&amp;Sign out of browsers</source>
        <translation>退出浏览器登录(&amp;S)</translation>
    </message>
    <message>
        <source>Ends whatever the chosen users have open in browsers, within the moment of their next click.</source>
        <translation>结束所选用户在各浏览器中的登录，下一次点击时即生效。</translation>
    </message>
    <message>
        <source>Signed out of every browser: %1. Drafts are kept.</source>
        <translation>已退出所有浏览器：%1 人。草稿保留。</translation>
    </message>
    <message>
        <source>&amp;Browsers…</source>
        <translation>浏览器(&amp;B)…</translation>
    </message>
    <message>
        <source>Let physicians score from their browsers: opens and closes the review desk here.</source>
        <translation>让医师在自己的浏览器中评分：在此开放或关闭评分台。</translation>
    </message>
</context>
<context>
    <name>torsio::gui::ValidityButton</name>
    <message>
        <source>What of this scene is measured, sourced and assumed</source>
        <translation>本场景中哪些是实测、引自文献和假设</translation>
    </message>
    <message>
        <source>How far this scene holds</source>
        <translation>本场景的有效范围</translation>
    </message>
</context>
</TS>
