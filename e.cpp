#include <bits/stdc++.h>
using namespace std; 
mt19937_64 R(7); double U(){return (R()>>11)*0x1p-53;} normal_distribution<double> NN;
double prob(double p,double rho,double p0,double p1,double h,int n){double s=log((1-p0)/(1-p1)),f=log(p0/p1);map<pair<long,int>,double>cur{{{0,0},1-p},{{0,1},p}};double tot=0;auto key=[](double x){return lround(x*1e9);};
 for(int t=0;t<n;t++){map<pair<long,int>,double>nx;for(auto&[k,w]:cur){double x=k.first*1e-9;double pf=k.second?p+rho*(1-p):p*(1-rho);if(x+s>=h-1e-7)tot+=w*(1-pf);else nx[{key(x+s),0}]+=w*(1-pf);nx[{key(max(0.,x+f)),1}]+=w*pf;}cur.swap(nx);}return tot;}
double limit(double p0,double p1,int n,double al,double rho){double s=log((1-p0)/(1-p1));int lo=0,hi=n*s*100;if(prob(p1,rho,p0,p1,hi/100.,n)>al)return NAN;while(hi-lo>1){int m=(lo+hi)/2;(prob(p1,rho,p0,p1,m/100.,n)<=al?hi:lo)=m;}return hi/100.;}
const int K=10,W=8; double rf(double q){double t=0;for(int j=0;j<W;j++)t+=exp(lgamma(K+1)-lgamma(j+1)-lgamma(K-j+1))*pow(1-q,j)*pow(q,K-j);return t;}
double sig(double x){return 1/(1+exp(-x));}
template<class F>double gauss(F f){double t=0,w=0;for(double z=-8;z<=8;z+=.02){double g=exp(-z*z/2);t+=g*f(z);w+=g;}return t/w;}
template<class F>double solve(F f,double p){double lo=-12,hi=8;for(int i=0;i<60;i++){double m=(lo+hi)/2;(f(m)<p?lo:hi)=m;}return lo;}
typedef vector<vector<bool>> S;
S seqs(bool twist,double p,int N,int n,int ses,double sd=1){auto fr=[&](double x){return twist?rf(sig(x)):sig(x);};double a=solve([&](double a){return gauss([&](double z){return fr(a+sd*z);});},p);S o;for(int i=0;i<N;i++){vector<bool>v;double pr=0;for(int t=0;t<n;t++){if(t%ses==0)pr=fr(a+sd*NN(R));v.push_back(U()<pr);}o.push_back(v);}return o;}
double est(const S&x){auto g=[&](double r){double t=0;map<int,double>Sn;for(auto&v:x){int n=v.size(),f=0,FF=0;for(int i=0;i<n;i++){f+=v[i];if(i)FF+=v[i]&&v[i-1];}auto it=Sn.find(n);if(it==Sn.end()){double s=0;for(int k=1;k<n;k++)s+=(n-k)*pow(r,k);it=Sn.emplace(n,s).first;}double s=it->second;double pq=double(f)*(n-f)/(n*(n-1.)-2*s);t+=FF-f*(f-1.)/n-pq*((n-1)*r-2*s/n);}return t;};double lo=-.3,hi=.95;for(int i=0;i<50;i++){double m=(lo+hi)/2;(g(m)>0?lo:hi)=m;}return lo;}
double decl(const S&x,double p0,double p1,double h){double s=log((1-p0)/(1-p1)),fw=log(p0/p1);int d=0;for(auto&v:x){double c=0;for(bool b:v){c=max(0.,c+(b?fw:s));if(c>=h-1e-9){d++;break;}}}return d/double(x.size());}
int main(){double p0=.05,p1=.3;int n=50;
for(int tw:{1,0})for(int ses:{1,3,5,10}){S c;for(double p:{.05,.1,.15,.2,.25,.3}){S y=seqs(tw,p,400,50,ses);c.insert(c.end(),y.begin(),y.end());}double r=est(c),r3=est(seqs(tw,.3,4000,50,ses));double h=limit(p0,p1,n,.025,max(0.,r));double h3=limit(p0,p1,n,.025,max(0.,r3));
for(double p:{.3,.2,.05})printf("%s ses %d rho %.3f at.3 %.3f h %.2f p %.2f declared %.4f printed %.4f | h3 %.2f declared %.4f printed %.4f\n",tw?"twist":"run",ses,r,r3,h,p,decl(seqs(tw,p,20000,n,ses),p0,p1,h),prob(p,max(0.,r),p0,p1,h,n),h3,decl(seqs(tw,p,20000,n,ses),p0,p1,h3),prob(p,max(0.,r3),p0,p1,h3,n));fflush(stdout);}
}
